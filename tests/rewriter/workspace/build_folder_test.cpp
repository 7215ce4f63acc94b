// SPDX-License-Identifier: BSD-3-Clause
#include "workspace/build_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "edits/files.h"
#include "support/temp_dir.h"

namespace tzc::rewriter {
namespace {

namespace fs = std::filesystem;

/// A workspace with a package demo, built nowhere yet.
class BuildFolder : public testing::Test {
 protected:
  BuildFolder() { folder.write("ws/src/demo/node.cpp", ""); }

  void database(const std::string& place, const std::string& file = "ws/src/demo/node.cpp") {
    folder.write(place + "/compile_commands.json",
                 R"([{"directory": "/", "command": "c++ -c x", "file": ")" + (folder / file) + "\"}]");
  }
  void configured(const std::string& place) { folder.write(place + "/CMakeCache.txt", ""); }
  std::string found(const std::string& given = "") {
    const PackagePlace demo{canonical_path(folder / "ws/src/demo"), "demo"};
    const Expected<std::string> place = find_build_dir(demo, given.empty() ? "" : folder / given, {});
    return place ? *place : to_string(place.error());
  }

  const tzc::test::TempDir folder;
};

TEST_F(BuildFolder, is_where_an_editors_link_leads) {
  database("ws/build/demo");
  configured("ws/build/demo");
  for (const char* link : {"ws/src/demo", "ws/src", "ws"}) {
    const std::string at = folder / (std::string(link) + "/compile_commands.json");
    fs::create_symlink(folder / "ws/build/demo/compile_commands.json", at);
    EXPECT_EQ(found(), folder / "ws/build/demo") << link;
    EXPECT_EQ(found(link), folder / "ws/build/demo") << link;
    EXPECT_EQ(found(std::string(link) + "/compile_commands.json"), folder / "ws/build/demo") << link;
    fs::remove(at);
  }
}

TEST_F(BuildFolder, is_one_that_cmake_configured_before_one_with_a_copy) {
  database("ws/src");
  EXPECT_EQ(found(), folder / "ws/src");
  database("ws/build");
  configured("ws/build");
  EXPECT_EQ(found(), folder / "ws/build");
}

TEST_F(BuildFolder, is_not_where_a_link_in_it_leads) {
  database("ws/merged");
  configured("ws/build");
  fs::create_symlink(folder / "ws/merged/compile_commands.json", folder / "ws/build/compile_commands.json");
  EXPECT_EQ(found(), folder / "ws/build");
}

TEST_F(BuildFolder, may_be_named_with_that_of_all_packages) {
  database("ws/build_release/demo");
  database("ws/build_release/other", "ws/src/other/node.cpp");
  EXPECT_EQ(found("ws/build_release"), folder / "ws/build_release/demo");
  EXPECT_THAT(found("ws/build_release/other"), testing::HasSubstr("has no compile command for any file of"));
}

TEST_F(BuildFolder, the_hint_has_the_workspaces_own_tool) {
  EXPECT_THAT(found(), testing::HasSubstr("as in: catkin_make -D"));
  folder.write("ws/.catkin_tools/profile", "");
  EXPECT_THAT(found(), testing::HasSubstr("as in: catkin config --append-args --cmake-args -D"));
  EXPECT_THAT(found("ws"), testing::HasSubstr("&& catkin build"));
}

TEST(ConfiguredFolder, is_one_whose_cache_names_the_package) {
  const tzc::test::TempDir folder;
  folder.write("ws/src/demo/package.xml", "");
  folder.write("ws/build/CMakeCache.txt", "other_SOURCE_DIR:STATIC=" + (folder / "ws/src/demo") + "\n");
  const PackagePlace demo{canonical_path(folder / "ws/src/demo"), "demo"};
  EXPECT_EQ(find_configured_dir(demo, "", {}), "");
  EXPECT_EQ(find_configured_dir(demo, folder / "ws/build", {}), "");
  const std::string named = "demo_SOURCE_DIR:STATIC=";
  folder.write("ws/build/CMakeCache.txt", named + (folder / "ws/src/other") + "\n");
  EXPECT_EQ(find_configured_dir(demo, "", {}), "") << "another package of that name";
  folder.write("ws/build/CMakeCache.txt", named + (folder / "ws/src/demo") + "\n");
  EXPECT_EQ(find_configured_dir(demo, "", {}), "") << "CMake has not generated: it failed, or still runs";
  folder.write("ws/build/CMakeFiles/TargetDirectories.txt", "");
  EXPECT_EQ(find_configured_dir(demo, "", {}), folder / "ws/build");
  EXPECT_EQ(find_configured_dir(demo, folder / "ws/build/compile_commands.json", {}), folder / "ws/build");
  const auto exports = [&](const std::string& value) {
    folder.write("ws/build/CMakeCache.txt", named + (folder / "ws/src/demo") + "\n" + value);
    return static_cast<bool>(check_exports(folder / "ws/build", demo));
  };
  EXPECT_FALSE(exports("")) << "its targets may compile anything";
  EXPECT_FALSE(exports("CMAKE_EXPORT_COMPILE_COMMANDS:BOOL=off\n"));
  EXPECT_TRUE(exports("CMAKE_EXPORT_COMPILE_COMMANDS:BOOL=ON\n"));
  EXPECT_TRUE(exports("CMAKE_EXPORT_COMPILE_COMMANDS:UNINITIALIZED=1\n"));
  folder.write("ws/build/compile_commands.json", "[]");
  EXPECT_TRUE(exports(""));
}

}  // namespace
}  // namespace tzc::rewriter
