// SPDX-License-Identifier: BSD-3-Clause
#include "paper/tool_tables.h"

#include <gmock/gmock.h>

namespace tzc::bench {
namespace {

using testing::ElementsAre;

TEST(SizeOfDiff, counts_what_hunks_add_and_remove) {
  const DiffSize size = size_of_diff(
      "diff --git a/x.cpp b/x.cpp\n--- a/x.cpp\n+++ b/x.cpp\n@@ -1,3 +1,4 @@ int main() {\n "
      "same\n-old\n+new\n+newer\n same\n"
      "@@ -9 +10 @@\n-one\n+other\n\\ No newline at end of file\n"
      "--- a/CMakeLists.txt\n+++ b/CMakeLists.txt\n@@ -0,0 +1,2 @@\n+a\n+b\n");
  EXPECT_EQ(size.files, 2U);
  EXPECT_EQ(size.added, 5U);
  EXPECT_EQ(size.removed, 2U);
}

TEST(SizeOfDiff, takes_content_that_looks_like_a_heading_for_content) {
  const DiffSize size =
      size_of_diff("--- a/x\n+++ b/x\n@@ -1,2 +1,2 @@\n--- a comment of Lua\n+++ counter;\n same\n");
  EXPECT_EQ(size.files, 1U);
  EXPECT_EQ(size.added, 1U);
  EXPECT_EQ(size.removed, 1U);
}

TEST(SizeOfDiff, of_nothing_is_nothing) {
  EXPECT_EQ(size_of_diff("").files, 0U);
}

TEST(TypesRow, has_shares_of_types_and_of_those_with_a_variable_array) {
  EXPECT_THAT(
      types_row("here", R"({"totals": {"types": 358, "has_variable_array": 112, "has_data_part": 98}})"),
      ElementsAre("here", "358", "112", "31.3", "98", "87.5"));
}

TEST(TypesRow, has_no_share_of_nothing) {
  EXPECT_THAT(types_row("empty", R"({"totals": {"types": 0, "has_variable_array": 0, "has_data_part": 0}})"),
              ElementsAre("empty", "0", "0", "", "0", ""));
}

TEST(CountTypes, says_which_folder_cannot_be_read) {
  std::vector<std::string> said;
  EXPECT_FALSE(count_types("/nonexistent/folder", {"/nonexistent/folder"}, said));
  ASSERT_EQ(said.size(), 1U);
  EXPECT_THAT(said[0],
              testing::AllOf(testing::HasSubstr("/nonexistent/folder"), testing::EndsWith("left out")));
}

}  // namespace
}  // namespace tzc::bench
