// SPDX-License-Identifier: BSD-3-Clause
// Reading a source's text where there is no syntax tree.
#include "edits/source_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tzc::rewriter::test {
namespace {

using testing::ElementsAre;

TEST(SourceText, comments_and_literals_are_blanked_in_place) {
  EXPECT_EQ(without_comments("a; // b {\nc"), "a;       \nc");
  EXPECT_EQ(without_comments("a /* b\n } */ c"), "a     \n      c");
  EXPECT_EQ(without_comments("f(\"x } // y\", '{');"), "f(\"        \", ' ');");
  EXPECT_EQ(without_comments("\"a\\\"b\" c"), "\"    \" c");
}

TEST(SourceText, raw_strings_and_comments_of_several_lines) {
  EXPECT_EQ(without_comments("f(R\"x(\n#else )\" \\)x\", 1);"), "f(R\"  \n            \", 1);");
  EXPECT_EQ(without_comments("u8R\"(\"})\"; }"), "u8R\"    \"; }");
  EXPECT_EQ(without_comments("FOR\"(\" {"), "FOR\" \" {");
  EXPECT_EQ(without_comments("// a \\\n#else\\\r\n{\n}"), "      \n       \n \n}");
}

TEST(SourceText, a_digit_separator_begins_no_literal) {
  EXPECT_EQ(without_comments("1'000 + b + 1'000"), "1'000 + b + 1'000");
}

TEST(SourceText, what_is_not_closed_ends_with_the_text) {
  EXPECT_EQ(without_comments("a /* b"), "a     ");
  EXPECT_EQ(without_comments("\"a\\"), "\"  ");
  EXPECT_EQ(without_comments("R\"x(a)y\""), "R\"      ");
  EXPECT_EQ(without_comments("R\"x"), "R\" ");
  EXPECT_EQ(without_comments("// a\\\n"), "     \n");
}

std::vector<std::string> definitions(const std::string& text) {
  std::vector<std::string> words;
  for (const auto& [definition, range] : definitions_in(text)) words.push_back(definition);
  return words;
}

TEST(SourceText, definitions_of_namespaces) {
  EXPECT_THAT(
      definitions("#pragma once\n#define X { \\\n {\nnamespace a { namespace b {\n"
                  "class C : D {\n int f() { return 1; }\n};\n} inline int f( int x ) { return { x }; } }\n"
                  "extern int y;"),
      ElementsAre("classC:D{intf(){return1;}}", "externinty", "inlineintf(intx){return{x};}"));
}

TEST(SourceText, what_two_programs_may_define_differently_is_left_out) {
  EXPECT_THAT(definitions("namespace { int a; }\nstatic int b() { return 1; }\nint main(int, char**) { }\n"
                          "void declared(int);\nclass Known;\nusing Name = int;\ntypedef int Other;"),
              ElementsAre());
}

TEST(SourceText, words_are_whole_words) {
  EXPECT_THAT(
      definitions("static_queue a;\nstructure b;\nint remain(int) { return 0; }\nvoid namespace_of() { }\n"
                  "extern \"\" { class C { }; }"),
      ElementsAre("classC{}", "intremain(int){return0;}", "static_queuea", "structureb",
                  "voidnamespace_of(){}"));
}

TEST(SourceText, a_definition_lies_where_it_is_written) {
  const std::string text = "int a;\nstruct B { int c; };\n";
  const TextRange range = definitions_in(text).at("structB{intc;}");
  EXPECT_LE(range.begin, text.find("struct"));
  EXPECT_EQ(text[range.end - 1], '}');
}

TEST(SourceText, identifiers_are_whole_words) {
  EXPECT_THAT(identifiers_in("image_.data = other(image, 3);"),
              ElementsAre("3", "data", "image", "image_", "other"));
}

TEST(SourceText, a_place_beyond_the_text_is_its_end) {
  EXPECT_EQ(offset_of("ab\ncd", 2, 2), 4u);
  EXPECT_EQ(offset_of("ab\ncd", 3, 1), 5u);
  EXPECT_EQ(offset_of("ab\ncd", 2, 9), 5u);
}

TEST(SourceText, a_local_lives_until_its_block_ends) {
  const std::string text = "void f() { { int a; { } b(); } c(); }";
  EXPECT_EQ(text.substr(end_of_block(text, text.find("int a"))), " c(); }");
}

TEST(SourceText, a_parameter_lives_until_the_body_ends) {
  const std::string text = "void f(int a) { if (a) { } } int b;";
  EXPECT_EQ(text.substr(end_of_function(text, text.find("int a"))), " int b;");
  const std::string declaration = "void f(int a); void g() {}";
  EXPECT_EQ(end_of_function(declaration, 7), 7u);
}

TEST(SourceText, the_function_of_a_parameter_is_named) {
  const std::string text = "void run(int (*g)(int), Image image) {}";
  EXPECT_EQ(function_around(text, text.find("Image")), "run");
  EXPECT_EQ(function_around("int a; Image image;", 8), "");
  EXPECT_EQ(function_around("f(); Image image;", 6), "");
}

}  // namespace
}  // namespace tzc::rewriter::test
