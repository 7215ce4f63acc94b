// SPDX-License-Identifier: BSD-3-Clause
#include "format/format.h"

#include <gtest/gtest.h>

#include "support/temp_dir.h"

namespace tzc::rewriter {
namespace {

/// A source below a folder with this .clang-format (none when empty), changed from `before` to `after`.
std::string formatted(const std::string& style, const std::string& before, const std::string& after) {
  tzc::test::TempDir package;
  if (!style.empty()) package.write(".clang-format", style);
  return format_changes(package / "src/a.cpp", before, after);
}

TEST(FormatChanges, no_style_no_change) {
  EXPECT_EQ(formatted("", "int a;\n", "int   a ;\n"), "int   a ;\n");
}
TEST(FormatChanges, changed_lines_follow_the_style_of_the_package) {
  EXPECT_EQ(formatted("{BasedOnStyle: Google, ColumnLimit: 30}", "int  x;\nf(a);\n",
                      "int  x;\nlong_name(argument_one, argument_two);\n"),
            "int  x;\nlong_name(argument_one,\n          argument_two);\n");
}
TEST(FormatChanges, untouched_lines_stay_as_they_are) {
  EXPECT_EQ(formatted("BasedOnStyle: LLVM", "int   a;\n\n\nint b;\n", "int   a;\n\n\nint   c;\n"),
            "int   a;\n\n\nint c;\n");
}
TEST(FormatChanges, includes_are_not_sorted) {
  const std::string after = "#include <z.h>\n#include <a.h>\n";
  EXPECT_EQ(formatted("BasedOnStyle: Google", "#include <z.h>\n", after), after);
}
TEST(FormatChanges, options_that_change_more_than_white_space_are_not_followed) {
  const std::string after = "void f() {\n  if (a) b();\n}\n";
  EXPECT_EQ(formatted("{BasedOnStyle: Google, InsertBraces: true}", "void f() {\n}\n", after), after);
}
TEST(FormatChanges, options_of_another_clang_format_are_passed_over) {
  EXPECT_EQ(formatted("{BasedOnStyle: LLVM, NoSuchOption: 3}", "int a;\n", "int   b;\n"), "int b;\n");
}
TEST(FormatChanges, a_style_that_cannot_be_read_is_no_style) {
  EXPECT_EQ(formatted("]", "int a;\n", "int   b;\n"), "int   b;\n");
}
TEST(FormatChanges, a_style_that_cannot_be_read_says_nothing_and_continuation_lines_keep_their_alignment) {
  testing::internal::CaptureStderr();
  EXPECT_EQ(
      formatted("{IndentWidth: two}", "int x = f(a,\n          b);\n", "int x = longer(a,\n          b);\n"),
      "int x = longer(a,\n               b);\n");
  const std::string said = testing::internal::GetCapturedStderr();
  if (TZC_CLANG_MAJOR >= 19) {  // earlier ones cannot be kept silent
    EXPECT_EQ(said, "");
  }
}
TEST(FormatChanges, windows_line_endings_stay) {
  EXPECT_EQ(formatted("BasedOnStyle: LLVM", "int a;\r\n", "int   b;\r\nint c;\r\n"), "int b;\r\nint c;\r\n");
}

}  // namespace
}  // namespace tzc::rewriter
