// SPDX-License-Identifier: BSD-3-Clause
#include "tool/places.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "support/temp_dir.h"

namespace tzc::rewriter {
namespace {

namespace fs = std::filesystem;

TEST(PackagesOfAFolder, are_found_behind_links_as_catkin_finds_them) {
  const tzc::test::TempDir folder;
  for (const char* package :
       {"ws/src/own", "git/robot/drivers/camera", "git/robot/deep/in/it/tool", "git/alone",
        "git/robot/ignored", "ws/install/share/own", "far/away/in/the/disk"})
    folder.write(std::string(package) + "/package.xml", "");
  folder.write("git/robot/ignored/CATKIN_IGNORE", "");
  const auto link = [&](const std::string& to, const std::string& at) {
    fs::create_symlink(folder / to, folder / at);
  };
  link("git/robot", "ws/src/robot");
  link("git/robot", "ws/src/again");
  link("git/alone", "ws/src/alone");
  link("ws", "ws/src/circle");
  link("", "ws/src/all");
  link("ws/src", "git/robot/back");
  link("nowhere", "ws/src/broken");
  const Expected<std::vector<std::string>> packages = find_packages_at(folder / "ws/src");
  ASSERT_TRUE(packages);
  std::string found;
  for (const std::string& package : *packages) found += package.substr(folder.path().size()) + " ";
  EXPECT_EQ(found, "/git/alone /git/robot/drivers/camera /ws/src/own ");
}

TEST(SourceSpace, is_what_catkin_has_marked) {
  for (const char* mark : {".catkin_tools/profile", ".catkin_workspace", "build_isolated/log"}) {
    const tzc::test::TempDir folder;
    folder.write(std::string("ws/") + mark, "");
    folder.write("ws/code/stack/src/demo/package.xml", "");
    EXPECT_EQ(source_space(folder / "ws/code/stack/src/demo"), folder / "ws/code");
  }
}

TEST(SourceSpace, is_called_src_where_nothing_was_built_yet) {
  const tzc::test::TempDir folder;
  folder.write("src/ws/src/stack/demo/package.xml", "");
  EXPECT_EQ(source_space(folder / "src/ws/src/stack/demo"), folder / "src/ws/src");
}

TEST(SourceSpace, is_the_folder_around_the_package_at_least) {
  const tzc::test::TempDir folder;
  EXPECT_EQ(source_space(folder / "stack/demo"), folder / "stack");
}

TEST(SourceSpace, of_a_workspace_is_told_from_any_other_folder) {
  const tzc::test::TempDir folder;
  folder.write("ws/.catkin_tools/profile", "");
  EXPECT_TRUE(is_workspace(folder / "ws/code"));
  EXPECT_TRUE(is_workspace(folder / "robot/src"));
  EXPECT_FALSE(is_workspace(folder / "robot"));
}

}  // namespace
}  // namespace tzc::rewriter
