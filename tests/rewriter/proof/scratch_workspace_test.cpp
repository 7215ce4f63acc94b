// SPDX-License-Identifier: BSD-3-Clause
#include "proof/scratch_workspace.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "edits/files.h"
#include "support/temp_dir.h"

namespace tzc::rewriter {
namespace {

namespace fs = std::filesystem;

TEST(ScratchWorkspace, a_package_behind_a_link_has_one_place_the_links) {
  const tzc::test::TempDir folder;
  folder.write("git/robot/demo/package.xml", "<package/>");
  folder.write("git/robot/other/package.xml", "<package/>");
  folder.write("ws/src/group/own.txt", "");
  fs::create_symlink(folder / "ws", folder / "ws/src/circle");
  fs::create_symlink(folder / "git/robot", folder / "ws/src/group/robot");
  const std::string demo = folder / "git/robot/demo";
  ScratchWorkspace copy(folder / "ws/src", {demo}, folder / "scratch", {});
  ASSERT_TRUE(copy.make());
  EXPECT_EQ(copy.named(demo), folder / "ws/src/group/robot/demo");
  EXPECT_EQ(copy.scratch(demo), folder / "scratch/group/robot/demo");
  EXPECT_FALSE(fs::is_symlink(folder / "scratch/group/robot/demo"));
  EXPECT_TRUE(fs::is_symlink(folder / "scratch/group/robot/other"));
  EXPECT_FALSE(fs::exists(folder / "scratch/demo")) << "catkin would find two packages of that name";
  ASSERT_TRUE(copy.write({{demo + "/package.xml", "<ported/>"}}));
  EXPECT_EQ(folder.read("scratch/group/robot/demo/package.xml"), "<ported/>");
  EXPECT_EQ(folder.read("git/robot/demo/package.xml"), "<package/>");
}

}  // namespace
}  // namespace tzc::rewriter
