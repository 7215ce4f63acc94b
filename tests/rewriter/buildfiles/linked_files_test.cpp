// SPDX-License-Identifier: BSD-3-Clause
// Build files that are links, and folders of a build that lie outside of the package.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "buildfiles/cmake_edits.h"
#include "buildfiles/plan.h"
#include "edits/files.h"
#include "model/codes.h"
#include "support/temp_dir.h"

namespace tzc::rewriter {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::IsEmpty;

constexpr const char* head = "project(demo)\nfind_package(catkin REQUIRED COMPONENTS roscpp)\n";

/// A package demo whose node.cpp is ported, in a folder with others.
class LinkedFiles : public testing::Test {
 protected:
  LinkedFiles() {
    folder.write("demo/node.cpp", "");
    write_manifest("demo/package.xml");
  }
  void write_manifest(const std::string& name) const {
    folder.write(
        name,
        "<package format=\"2\">\n  <name>demo</name>\n  <buildtool_depend>catkin</buildtool_depend>\n"
        "</package>\n");
  }
  void link(const std::string& target, const std::string& at) const {
    fs::remove(folder / at);
    fs::create_symlink(target, folder / at);
  }
  /// The plan of a port of node.cpp, which this target compiles.
  BuildPlan plan(const std::string& target) const {
    const std::string file = folder / "demo/node.cpp";
    folder.write("build/compile_commands.json",
                 nlohmann::json::array({{{"directory", folder.path()},
                                         {"file", file},
                                         {"command", "c++ -o CMakeFiles/" + target + ".dir/x.o -c " + file}}})
                     .dump());
    BuildNeeds needs;
    needs.package_dir = folder / "demo";
    needs.build_dir = folder / "build";
    needs.main_files = needs.edited_files = {file};
    const Expected<BuildPlan> found = plan_build_files(needs);
    EXPECT_TRUE(found);
    return found ? *found : BuildPlan();
  }
  std::set<std::string> edited(const BuildPlan& plan) const {
    std::set<std::string> files;
    for (const Edit& edit : plan.edits) files.insert(fs::relative(edit.file, folder.path()));
    return files;
  }
  std::vector<std::string> notes(const BuildPlan& plan) const {
    std::vector<std::string> texts;
    for (const Note& note : plan.notes)
      texts.push_back(note.code + " " + fs::relative(note.where->file, folder.path()).string());
    return texts;
  }

  const tzc::test::TempDir folder;
};

TEST_F(LinkedFiles, are_edited_where_they_lead) {
  write_manifest("demo/ros1/package.xml");
  folder.write("demo/ros1/CMakeLists.txt",
               std::string(head) + "add_executable(node node.cpp)\nadd_subdirectory(sub)\n");
  folder.write("demo/sub/CMakeLists.txt", "target_link_libraries(node ${roscpp_LIBRARIES})\n");
  link("ros1/package.xml", "demo/package.xml");
  link("ros1/CMakeLists.txt", "demo/CMakeLists.txt");
  const BuildPlan found = plan("node");
  EXPECT_THAT(edited(found),
              ElementsAre("demo/ros1/CMakeLists.txt", "demo/ros1/package.xml", "demo/sub/CMakeLists.txt"));
  EXPECT_THAT(notes(found), IsEmpty());
}

TEST_F(LinkedFiles, that_lead_out_of_the_package_stay) {
  folder.write("common/CMakeLists.txt", std::string(head) + "add_executable(node node.cpp)\n");
  link("../common/CMakeLists.txt", "demo/CMakeLists.txt");
  const BuildPlan found = plan("node");
  EXPECT_THAT(edited(found), ElementsAre("demo/package.xml"));
  EXPECT_THAT(notes(found), ElementsAre(std::string(codes::TZC4002) + " common/CMakeLists.txt"));
}

TEST_F(LinkedFiles, a_folder_that_is_built_beside_the_package_stays) {
  folder.write("demo/CMakeLists.txt", std::string(head) + "add_subdirectory(../core core)\n");
  folder.write("core/CMakeLists.txt", "set(CMAKE_CXX_STANDARD 11)\nadd_library(core ../demo/node.cpp)\n");
  const BuildPlan found = plan("core");
  EXPECT_THAT(edited(found), ElementsAre("demo/CMakeLists.txt", "demo/package.xml"));
  EXPECT_THAT(notes(found), ElementsAre(std::string(codes::TZC4002) + " core/CMakeLists.txt"));
}

TEST_F(LinkedFiles, an_exported_folder_is_what_its_links_lead_to_as_well) {
  folder.write("demo/CMakeLists.txt", std::string(head) +
                                          "catkin_package(INCLUDE_DIRS include)\n"
                                          "add_executable(node node.cpp)\n");
  for (const char* header : {"core/include/a.h", "src/b.h", "private/c.h", "private/d.h"})
    folder.write(std::string("demo/") + header, "");
  folder.write("elsewhere/e.h", "");
  fs::create_directory_symlink("core/include", folder / "demo/include");
  fs::create_directory_symlink("../../src", folder / "demo/core/include/demo");
  fs::create_symlink("../../private/c.h", folder / "demo/core/include/c.h");
  fs::create_directory_symlink("../../../elsewhere", folder / "demo/core/include/other");
  const Expected<CmakeProject> project = load_cmake_project(folder / "demo");
  ASSERT_TRUE(project);
  std::vector<std::string> exported;
  for (const std::string& path : exported_folders(*project, folder / "demo"))
    exported.push_back(fs::relative(path, folder.path()));
  EXPECT_THAT(exported, ElementsAre("demo/core/include", "demo/private/c.h", "demo/src"));
}

}  // namespace
}  // namespace tzc::rewriter
