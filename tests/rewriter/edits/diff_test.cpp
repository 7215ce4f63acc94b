// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <random>

#include "edits/diff.h"
#include "support/temp_dir.h"

namespace tzc::rewriter {
namespace {

std::string lines(int first, int last) {
  std::string text;
  for (int i = first; i <= last; ++i) text += std::to_string(i) + "\n";
  return text;
}

std::string diff(const std::string& before, const std::string& after) {
  return unified_diff("f", before, after, false).text;
}

TEST(UnifiedDiff, equal_contents_give_nothing) {
  EXPECT_EQ(diff("a\n", "a\n"), "");
}

TEST(UnifiedDiff, a_change_with_context) {
  EXPECT_EQ(diff(lines(1, 9), lines(1, 4) + "five\n" + lines(6, 9)),
            "--- a/f\n+++ b/f\n@@ -2,7 +2,7 @@\n 2\n 3\n 4\n-5\n+five\n 6\n 7\n 8\n");
}
TEST(UnifiedDiff, removed_lines_stand_before_added_ones) {
  EXPECT_EQ(diff("a\nb\n", "x\ny\n"), "--- a/f\n+++ b/f\n@@ -1,2 +1,2 @@\n-a\n-b\n+x\n+y\n");
}
TEST(UnifiedDiff, far_changes_get_hunks_of_their_own) {
  const std::string text = diff("a\n" + lines(1, 20) + "b\n", "A\n" + lines(1, 20) + "B\n");
  EXPECT_NE(text.find("@@ -1,4 +1,4 @@"), std::string::npos);
  EXPECT_NE(text.find("@@ -19,4 +19,4 @@"), std::string::npos);
}
TEST(UnifiedDiff, into_and_out_of_an_empty_file) {
  EXPECT_EQ(diff("", "a\n"), "--- a/f\n+++ b/f\n@@ -0,0 +1 @@\n+a\n");
  EXPECT_EQ(diff("a\n", ""), "--- a/f\n+++ b/f\n@@ -1 +0,0 @@\n-a\n");
}
TEST(UnifiedDiff, no_newline_at_the_end) {
  EXPECT_EQ(diff("a\nb", "a\nB"),
            "--- a/f\n+++ b/f\n@@ -1,2 +1,2 @@\n a\n-b\n\\ No newline at end of file\n+B\n\\ No newline at "
            "end of file\n");
}
TEST(UnifiedDiff, carriage_returns_stay) {
  EXPECT_EQ(diff("a\r\nb\r\n", "a\r\nc\r\n"), "--- a/f\n+++ b/f\n@@ -1,2 +1,2 @@\n a\r\n-b\r\n+c\r\n");
}
TEST(UnifiedDiff, counts) {
  const DiffStat stat = unified_diff("f", "a\nb\nc\n", "a\nB\nc\nd\n", false).stat;
  EXPECT_EQ(stat.files, 1u);
  EXPECT_EQ(stat.added, 2u);
  EXPECT_EQ(stat.removed, 1u);
}
TEST(UnifiedDiff, header_for_git) {
  EXPECT_EQ(unified_diff("d/f", "a\n", "b\n", true).text.substr(0, 34),
            "diff --git a/d/f b/d/f\n--- a/d/f\n+");
}
TEST(UnifiedDiff, a_name_with_spaces_ends_with_a_tab) {
  EXPECT_EQ(unified_diff("my file", "a\n", "b\n", false).text.substr(0, 14), "--- a/my file\t");
}

/// git is the judge: whatever two contents, its apply must take our diff and arrive at the second.
class GitApply : public ::testing::TestWithParam<bool> {};

std::string random_content(std::mt19937& random) {
  std::string text;
  const char* endings[] = {"\n", "\r\n"};
  for (unsigned i = 0, n = random() % 30; i < n; ++i)
    text += std::string(1, 'a' + random() % 4) + endings[random() % 5 == 0];
  return random() % 3 == 0 ? text + "end" : text;
}

TEST_P(GitApply, takes_the_diff_of_random_contents) {
  tzc::test::TempDir folder;
  std::mt19937 random(7);
  const std::string apply =
      "cd '" + folder.path() + "' && git init -q . && git apply --whitespace=nowarn d.patch";
  for (int round = 0; round < 25; ++round) {
    const std::string before = random_content(random), after = random_content(random);
    const std::string patch = unified_diff("sub dir/f", before, after, GetParam()).text;
    if (patch.empty() || before.empty() || after.empty()) continue;
    folder.write("sub dir/f", before);
    folder.write("d.patch", patch);
    ASSERT_EQ(std::system(apply.c_str()), 0) << patch;
    ASSERT_EQ(folder.read("sub dir/f"), after) << patch;
  }
}
INSTANTIATE_TEST_SUITE_P(UnifiedDiff, GitApply, ::testing::Bool());

TEST(DiffLines, numbers_both_sides) {
  const auto all = diff_lines("a\nb\n", "a\nx\nb\n");
  ASSERT_EQ(all.size(), 3u);
  EXPECT_EQ(all[1].change, LineChange::added);
  EXPECT_EQ(all[1].new_number, 2u);
  EXPECT_EQ(all[2].old_number, 2u);
  EXPECT_EQ(all[2].new_number, 3u);
}

}  // namespace
}  // namespace tzc::rewriter
