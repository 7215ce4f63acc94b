// SPDX-License-Identifier: BSD-3-Clause
// What --apply says last: does catkin find tzc, and what is there to type?
#include "tool/next_steps.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "support/temp_dir.h"

namespace tzc::rewriter {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

class NextSteps : public ::testing::Test {
 protected:
  NextSteps() {
    ::unsetenv("CMAKE_PREFIX_PATH");
    folder.write("ws/src/group/demo/package.xml", "");
  }
  ~NextSteps() override { ::unsetenv("CMAKE_PREFIX_PATH"); }

  std::string steps(const std::string& build_dir = "") const {
    return next_steps({{folder / "ws/src/group/demo", build_dir.empty() ? "" : folder / build_dir}});
  }
  /// CMake has configured the folder `source` in the folder `tree`.
  void configured(const std::string& source, const std::string& tree,
                  const std::string& generator = "Unix Makefiles") const {
    folder.write(tree + "/CMakeCache.txt", "CMAKE_HOME_DIRECTORY:INTERNAL=" + (folder / source) +
                                               "\nCMAKE_GENERATOR:INTERNAL=" + generator + "\n");
  }
  std::string command(const std::string& builder) const {
    return "(cd " + (folder / "ws") + " && " + builder + ")\n";
  }

  tzc::test::TempDir folder;
};

TEST_F(NextSteps, a_workspace_that_does_not_find_tzc_gets_the_line_to_type) {
  EXPECT_THAT(steps(), HasSubstr("catkin will not find tzc in this shell"));
  EXPECT_THAT(steps(), HasSubstr("setup.bash\n"));
  EXPECT_THAT(steps(), HasSubstr(command("catkin_make")));
}

TEST_F(NextSteps, workspaces_that_were_sourced_before_are_kept) {
  ::setenv("CMAKE_PREFIX_PATH", (folder / "elsewhere").c_str(), 1);
  EXPECT_THAT(steps(), HasSubstr("setup.bash --extend\n"));
}

TEST_F(NextSteps, an_environment_with_tzc_needs_no_more_than_a_build) {
  folder.write("prefix/share/tzc/cmake/tzcConfig.cmake", "");
  ::setenv("CMAKE_PREFIX_PATH", ("/nowhere:" + (folder / "prefix")).c_str(), 1);
  EXPECT_EQ(steps(), "ported; build again:\n  " + command("catkin_make"));
}

TEST_F(NextSteps, tzc_may_be_a_member_of_the_workspace) {
  folder.write("ws/devel/share/tzc/cmake/tzcConfig.cmake", "");
  EXPECT_THAT(steps(), Not(HasSubstr("source")));
}

TEST_F(NextSteps, the_line_to_type_is_quoted_for_a_shell) {
  folder.write("my ws/src/demo/package.xml", "");
  EXPECT_THAT(next_steps({{folder / "my ws/src/demo", ""}}),
              HasSubstr("(cd '" + (folder / "my ws") + "' && "));
}

TEST_F(NextSteps, the_builder_is_the_one_that_the_workspace_is_built_with) {
  folder.write("ws/build_isolated/demo/Makefile", "");
  EXPECT_THAT(steps(), HasSubstr(command("catkin_make_isolated")));
  folder.write("ws/.catkin_tools/README", "");
  EXPECT_THAT(steps(), HasSubstr(command("catkin build")));
}

TEST_F(NextSteps, a_folder_that_catkin_make_configured) {
  configured("ws/src", "ws/build");
  folder.write("ws/build/.built_by", "catkin_make");
  EXPECT_THAT(steps("ws/build"), HasSubstr("  " + command("catkin_make")));
  configured("ws/src", "ws/build", "Ninja");
  EXPECT_THAT(steps("ws/build"), HasSubstr("  " + command("catkin_make --use-ninja")));
}

TEST_F(NextSteps, folders_that_are_configured_for_each_package) {
  configured("ws/src/group/demo", "ws/build_isolated/demo");
  EXPECT_THAT(steps("ws/build_isolated/demo"), HasSubstr(command("catkin_make_isolated")));
  configured("ws/src/group/demo", "ws/build/demo");
  folder.write("ws/.catkin_tools/README", "");
  EXPECT_THAT(steps("ws/build/demo"), HasSubstr(command("catkin build")));
}

/// A package on its own, one in a workspace that its user builds alone, and a workspace in another build folder.
TEST_F(NextSteps, what_cmake_alone_has_configured_is_built_with_cmake) {
  folder.write("ws/.catkin_workspace", "");
  folder.write("ws/.catkin_tools/README", "");
  const std::pair<const char*, const char*> trees[] = {{"alone/t1", "alone/t1/build"},
                                                       {"alone/t2", "alone/t2"},
                                                       {"ws/src/group/demo", "ws/src/group/demo/build"},
                                                       {"ws/src/group/demo", "ws/src/group/demo"},
                                                       {"ws/src", "ws/build2"}};
  for (const auto& [source, tree] : trees) {
    configured(source, tree);
    EXPECT_THAT(steps(tree), HasSubstr("  cmake --build " + (folder / tree) + "\n"));
    EXPECT_THAT(steps(tree), Not(HasSubstr("(cd ")));
  }
}

TEST_F(NextSteps, each_build_folder_is_named_once) {
  for (const char* name : {"one", "two"}) configured(name, std::string(name) + "/build");
  const std::string steps = next_steps({{folder / "one", folder / "one/build"},
                                        {folder / "one/x", folder / "one/build"},
                                        {folder / "two", folder / "two/build"}});
  EXPECT_THAT(steps, HasSubstr("\n  cmake --build " + (folder / "one/build") + "\n  cmake --build " +
                               (folder / "two/build") + "\n"));
}

}  // namespace
}  // namespace tzc::rewriter
