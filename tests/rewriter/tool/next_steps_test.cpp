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

  std::string steps() const { return next_steps(folder / "ws/src/group/demo"); }
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
  EXPECT_EQ(steps(), "ported; build the workspace again:\n  " + command("catkin_make"));
}

TEST_F(NextSteps, tzc_may_be_a_member_of_the_workspace) {
  folder.write("ws/devel/share/tzc/cmake/tzcConfig.cmake", "");
  EXPECT_THAT(steps(), Not(HasSubstr("source")));
}

TEST_F(NextSteps, the_line_to_type_is_quoted_for_a_shell) {
  folder.write("my ws/src/demo/package.xml", "");
  EXPECT_THAT(next_steps(folder / "my ws/src/demo"), HasSubstr("(cd '" + (folder / "my ws") + "' && "));
}

TEST_F(NextSteps, the_builder_is_the_one_that_the_workspace_is_built_with) {
  folder.write("ws/build_isolated/demo/Makefile", "");
  EXPECT_THAT(steps(), HasSubstr(command("catkin_make_isolated")));
  folder.write("ws/.catkin_tools/README", "");
  EXPECT_THAT(steps(), HasSubstr(command("catkin build")));
}

}  // namespace
}  // namespace tzc::rewriter
