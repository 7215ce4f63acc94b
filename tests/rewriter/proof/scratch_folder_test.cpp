// SPDX-License-Identifier: BSD-3-Clause
#include "proof/scratch_folder.h"

#include <gtest/gtest.h>
#include <stdlib.h>

#include <chrono>
#include <filesystem>

#include "support/temp_dir.h"

namespace tzc::rewriter {
namespace {

using tzc::test::TempDir;

namespace fs = std::filesystem;

class ScratchFolders : public ::testing::Test {
 protected:
  void SetUp() override { ::setenv("TMPDIR", temp_.path().c_str(), 1); }
  void TearDown() override { ::unsetenv("TMPDIR"); }

  static void make_old(const std::string& folder) {
    fs::last_write_time(folder, fs::file_time_type::clock::now() - std::chrono::minutes(2));
  }
  TempDir temp_;
};

TEST_F(ScratchFolders, is_removed_with_what_is_in_it) {
  std::string path;
  {
    Expected<ScratchFolder> folder = ScratchFolder::make();
    ASSERT_TRUE(folder);
    path = folder->path();
    fs::create_directories(*folder / "a/b");
  }
  EXPECT_FALSE(fs::exists(path));
}

TEST_F(ScratchFolders, what_a_killed_run_left_is_removed_by_the_next) {
  temp_.write("tzc-rewrite-killed/.lock", "");
  temp_.write("tzc-rewrite-killed/file", "");
  make_old(temp_ / "tzc-rewrite-killed");
  ASSERT_TRUE(ScratchFolder::make());
  EXPECT_FALSE(fs::exists(temp_ / "tzc-rewrite-killed"));
}

TEST_F(ScratchFolders, what_is_in_use_or_not_its_own_stays) {
  Expected<ScratchFolder> used = ScratchFolder::make();
  ASSERT_TRUE(used);
  make_old(used->path());
  temp_.write("tzc-rewrite-notes/file", "");
  make_old(temp_ / "tzc-rewrite-notes");
  temp_.write("tzc-rewrite-young/.lock", "");
  ASSERT_TRUE(ScratchFolder::make());
  for (const std::string& folder : {used->path(), temp_ / "tzc-rewrite-notes", temp_ / "tzc-rewrite-young"})
    EXPECT_TRUE(fs::exists(folder)) << folder;
}

TEST_F(ScratchFolders, no_room) {
  ::setenv("TMPDIR", "/nonexistent", 1);
  const Expected<ScratchFolder> folder = ScratchFolder::make();
  ASSERT_FALSE(folder);
  EXPECT_NE(to_string(folder.error()).find("TMPDIR"), std::string::npos);
}

}  // namespace
}  // namespace tzc::rewriter
