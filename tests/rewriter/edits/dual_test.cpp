// SPDX-License-Identifier: BSD-3-Clause
#include "edits/dual.h"

#include <gtest/gtest.h>

#include "support/temp_dir.h"

namespace tzc::rewriter {
namespace {

std::string dual(const std::string& before, const std::string& after) {
  const Expected<std::string> text = dual_text("f.cpp", before, after);
  return text ? *text : to_string(text.error()).substr(0, 7);
}

TEST(DualText, equal_contents_stay) {
  EXPECT_EQ(dual("a\n", "a\n"), "a\n");
}
TEST(DualText, changed_lines_stand_side_by_side) {
  EXPECT_EQ(dual("a\nold\nb\n", "a\nnew\nb\n"), "a\n#ifdef TZC_ENABLED\nnew\n#else\nold\n#endif\nb\n");
}
TEST(DualText, added_lines) {
  EXPECT_EQ(dual("a\nb\n", "a\nx\nb\n"), "a\n#ifdef TZC_ENABLED\nx\n#endif\nb\n");
}
TEST(DualText, removed_lines) {
  EXPECT_EQ(dual("a\nx\nb\n", "a\nb\n"), "a\n#ifndef TZC_ENABLED\nx\n#endif\nb\n");
}
TEST(DualText, last_line_without_an_end) {
  EXPECT_EQ(dual("x", "y"), "#ifdef TZC_ENABLED\ny\n#else\nx\n#endif\n");
}
TEST(DualText, windows_line_endings) {
  EXPECT_EQ(dual("x\r\n", "y\r\n"), "#ifdef TZC_ENABLED\r\ny\r\n#else\r\nx\r\n#endif\r\n");
}
TEST(DualText, inside_a_directive_of_several_lines_is_refused) {
  EXPECT_EQ(dual("#define A \\\n  x\n", "#define A \\\n  y\n"), "f.cpp:2");
}
TEST(DualText, inside_a_comment_of_several_lines_is_refused) {
  EXPECT_EQ(dual("/* a\n x\n*/\n", "/* a\n y\n*/\n"), "f.cpp:2");
  EXPECT_EQ(dual("\"a//b\"; /* a\n x\n*/\n", "\"a//b\"; /* a\n y\n*/\n"), "f.cpp:2");
  EXPECT_EQ(dual("// /*\nx\n", "// /*\ny\n"), "// /*\n#ifdef TZC_ENABLED\ny\n#else\nx\n#endif\n");
}
TEST(DualText, changed_lines_that_go_on_are_refused) {
  EXPECT_EQ(dual("x  // C:\\\n", "y  // C:\\\n"), "f.cpp:1");
  EXPECT_EQ(dual("a\nx\\\n;\n", "a\ny\n;\n"), "f.cpp:2") << "what is removed goes on";
  EXPECT_EQ(dual("x /* a\n*/\n", "y /* a\n*/\n"), "f.cpp:1");
  EXPECT_EQ(dual("x = R\"(\n)\";\n", "y = R\"(\n)\";\n"), "f.cpp:1");
}
TEST(DualText, banners_open_no_comment) {
  for (const std::string banner : {"//****", "// a /* b", "/* a */ // /*", "/***/", "\"/*\";"})
    EXPECT_EQ(dual(banner + "\nx\n", banner + "\ny\n"),
              banner + "\n#ifdef TZC_ENABLED\ny\n#else\nx\n#endif\n");
}

TEST(InDualBranch, knows_its_own_branches) {
  const std::string text = "a\n#ifdef TZC_ENABLED\nb\n#else\nc\n#endif\n#ifdef OTHER\nd\n#endif\n";
  std::string inside;
  for (unsigned line = 1; line <= 9; ++line) inside += in_dual_branch(text, line) ? "x" : "-";
  EXPECT_EQ(inside, "-xxxxx---");
}

/// The preprocessor is the judge: what it leaves with and without the macro.
TEST(DualText, reads_as_either_text) {
  const std::string before = "one\ntwo\nthree\nfour\n", after = "zero\none\nzwei\nthree\n";
  tzc::test::TempDir folder;
  folder.write("f.cpp", dual(before, after));
  const std::string run = "cd '" + folder.path() + "' && c++ -E -P ";
  ASSERT_EQ(std::system((run + "f.cpp > without").c_str()), 0);
  ASSERT_EQ(std::system((run + "-DTZC_ENABLED f.cpp > with").c_str()), 0);
  EXPECT_EQ(folder.read("without"), before);
  EXPECT_EQ(folder.read("with"), after);
}

}  // namespace
}  // namespace tzc::rewriter
