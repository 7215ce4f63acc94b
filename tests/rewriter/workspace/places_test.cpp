// SPDX-License-Identifier: BSD-3-Clause
#include "workspace/places.h"

#include <gtest/gtest.h>

#include "support/temp_dir.h"

namespace tzc::rewriter {
namespace {

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
