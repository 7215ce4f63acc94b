// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <algorithm>
#include <chrono>

#include "library_case.h"

namespace tzc::msggen::test {
namespace {

using ::testing::HasSubstr;

std::string rendered(const std::string& text) {
  Diagnostic d;
  d.file = d.message = d.hint = d.source_line = text;
  d.at = {1, 1};
  return render(d);
}

TEST(Diagnostic, a_terminal_gets_no_control_characters) {
  for (const char* control : {"\x1b", "\x01", "\n", "\x7f", "\xC2\x9b", "\x9b", "\xFF"}) {
    EXPECT_EQ(rendered(std::string("a") + control + "b"), "a?b:1:1: error: a?b\n  a?b\n  ^\n  hint: a?b\n");
  }
  EXPECT_THAT(rendered("gr\xC3\xBC\xC3\x9F \xC2\xA0\xF0\x9F\xA4\x96"),
              HasSubstr("error: gr\xC3\xBC\xC3\x9F \xC2\xA0\xF0\x9F\xA4\x96\n"));
}

TEST(Diagnostic, a_definition_cannot_write_to_the_terminal) {
  LibraryCase c;
  c.file("A.msg", "uint8 a\x1b]0;title\x07\nuint8 \xC2\x9b\nmissing_\x1b[2J/X x\n");
  c.library.find("demo/A");
  const std::string text = c.faults();
  EXPECT_THAT(text, HasSubstr("'a?]0;title?'"));
  EXPECT_TRUE(std::none_of(text.begin(), text.end(), [](char x) { return x == '\x1b' || x == '\x07'; }));
}

TEST(Diagnostic, a_long_text_is_cut_between_characters) {
  std::string text;
  for (int i = 0; i < 2000; ++i) text += "\xE2\x82\xAC";
  const std::string shown = rendered(text);
  EXPECT_LT(shown.size(), 7000u);
  EXPECT_EQ(shown.find('?'), std::string::npos);
}

TEST(Diagnostics, of_a_file_without_end_the_first_hundred_faults_are_shown) {
  std::string text;
  for (int i = 0; i < 300000; ++i) text += "a\n";
  LibraryCase c;
  const auto start = std::chrono::steady_clock::now();
  c.file("A.msg", text).file("B.msg", "b\n");
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(20)) << "quadratic: minutes";
  EXPECT_EQ(c.diagnostics.size(), 101u);
  EXPECT_THAT(c.faults(), HasSubstr("A.msg:100:1: error: 'a' is not a field: a type and a name are expected\n"
                                    "  a\n  ^\n"
                                    "A.msg: error: only the first 100 faults of this file are shown\n"
                                    "B.msg:1:1: error:"));
}

TEST(Diagnostics, a_hundred_faults_are_all) {
  std::string text;
  for (int i = 0; i < 100; ++i) text += "a\n";
  LibraryCase c;
  c.file("A.msg", text);
  EXPECT_EQ(c.diagnostics.sorted().size(), 100u);
}

TEST(Diagnostics, what_is_not_shown_is_wrong_nevertheless) {
  std::string text;
  for (int i = 0; i < 200; ++i) text += "Missing m" + std::to_string(i) + "\n";
  LibraryCase c;
  c.file("A.msg", text).file("A.msg", text).file("Go.action", text + "---\n" + text + "---\nb\n");
  for (const char* name : {"A", "GoGoal", "GoResult", "GoFeedback"})
    EXPECT_FALSE(c.library.find(std::string("demo/") + name)) << name;
}

}  // namespace
}  // namespace tzc::msggen::test
