// SPDX-License-Identifier: BSD-3-Clause
#include "model/folder_set.h"

#include <gtest/gtest.h>

namespace tzc::rewriter {
namespace {

TEST(FolderSet, holds_what_lies_in_one_of_its_folders) {
  const FolderSet folders(std::vector<std::string>{"/ws/a", "/ws/b"});
  EXPECT_EQ(*folders.of("/ws/b/src/node.cpp"), "/ws/b");
  EXPECT_TRUE(folders.hold("/ws/a/x"));
  EXPECT_FALSE(folders.hold("/ws/ab/x")) << "a name that only begins like it";
  EXPECT_FALSE(folders.hold("/ws/a")) << "the folder itself lies beside it";
  EXPECT_FALSE(FolderSet().hold("/ws/a/x"));
}

TEST(FolderSet, shows_a_path_as_its_folder_sees_it) {
  const FolderSet folders(std::vector<std::string>{"/ws/a", "/ws/b"});
  EXPECT_EQ(folders.relative("/ws/b/src/node.cpp"), "src/node.cpp");
  EXPECT_EQ(folders.relative("/usr/include/x.h"), "/usr/include/x.h");
}

TEST(FolderSet, of_the_root_holds_every_file) {
  EXPECT_TRUE(FolderSet(std::string("/")).hold("/x"));
  EXPECT_EQ(FolderSet(std::string("/")).relative("/usr/x"), "usr/x");
}

}  // namespace
}  // namespace tzc::rewriter
