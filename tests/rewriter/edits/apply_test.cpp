// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "edits/apply.h"

namespace tzc::rewriter {
namespace {

Edit edit(std::size_t offset, std::size_t length, const std::string& text, const std::string& rule = "rule") {
  return {"/p/a.cpp", offset, length, text, {}, rule};
}

std::string applied(const std::string& content, const Edits& edits) {
  const Expected<std::string> result = apply_edits(content, edits);
  return result ? *result : "error: " + to_string(result.error());
}

TEST(ApplyEdits, nothing) {
  EXPECT_EQ(applied("abc", {}), "abc");
}
TEST(ApplyEdits, replaces_inserts_and_deletes) {
  EXPECT_EQ(applied("abcdef", {edit(0, 1, "A"), edit(3, 0, "-"), edit(4, 2, "")}), "Abc-d");
}
TEST(ApplyEdits, order_does_not_matter) {
  EXPECT_EQ(applied("abc", {edit(2, 1, "C"), edit(0, 1, "A")}), "AbC");
}
TEST(ApplyEdits, at_both_ends) {
  EXPECT_EQ(applied("abc", {edit(3, 0, ">"), edit(0, 0, "<")}), "<abc>");
}
TEST(ApplyEdits, insertions_at_one_place_keep_their_order) {
  EXPECT_EQ(applied("ab", {edit(1, 0, "1"), edit(1, 0, "2"), edit(1, 0, "0")}), "a120b");
}
TEST(ApplyEdits, identical_edits_count_once) {
  EXPECT_EQ(applied("ab", {edit(1, 0, "x"), edit(1, 0, "x"), edit(0, 1, "A"), edit(0, 1, "A")}), "Axb");
}
TEST(ApplyEdits, insertion_goes_before_a_replacement_at_the_same_place) {
  EXPECT_EQ(applied("ab", {edit(1, 1, "B"), edit(1, 0, "+")}), "a+B");
}
TEST(ApplyEdits, neighbours_do_not_overlap) {
  EXPECT_EQ(applied("abcd", {edit(0, 2, "1"), edit(2, 2, "2")}), "12");
}

TEST(ApplyEdits, overlap_names_both_rules) {
  EXPECT_EQ(applied("abcd", {edit(0, 3, "x", "first"), edit(2, 1, "y", "second")}),
            "error: /p/a.cpp: edits of the rules 'first' and 'second' overlap at byte 2");
}
TEST(ApplyEdits, different_replacements_of_one_place_overlap) {
  EXPECT_NE(applied("abcd", {edit(0, 3, "x"), edit(0, 3, "y")}).find("overlap"), std::string::npos);
}
TEST(ApplyEdits, overlaps_are_found_in_all_files_and_duplicates_are_none) {
  Edits edits = {edit(0, 3, "x"), edit(0, 3, "x"), edit(1, 1, "y"), edit(2, 0, "z"), edit(3, 1, "w")};
  edits.push_back(edit(2, 2, "v"));
  edits.back().file = "/p/b.cpp";
  const auto found = overlaps(edits);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].first.text + found[0].second.text, "xy");
  EXPECT_EQ(found[1].first.text + found[1].second.text, "xz");
}
TEST(ApplyEdits, insertion_inside_a_replacement_overlaps) {
  EXPECT_NE(applied("abcd", {edit(0, 3, "x"), edit(1, 0, "y")}).find("overlap"), std::string::npos);
}
TEST(ApplyEdits, outside_the_file) {
  EXPECT_NE(applied("ab", {edit(1, 2, "x")}).find("outside"), std::string::npos);
  EXPECT_NE(applied("ab", {edit(3, 0, "x")}).find("outside"), std::string::npos);
}

TEST(ByFile, groups_in_order) {
  Edit other = edit(5, 0, "o");
  other.file = "/p/b.cpp";
  const auto files = by_file({edit(1, 0, "1"), other, edit(0, 0, "0")});
  ASSERT_EQ(files.size(), 2u);
  EXPECT_EQ(files.at("/p/a.cpp")[1].text, "0");
}

}  // namespace
}  // namespace tzc::rewriter
