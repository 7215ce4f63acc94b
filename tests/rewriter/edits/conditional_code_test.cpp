// SPDX-License-Identifier: BSD-3-Clause
// Which parts of a file are never compiled together.
#include "edits/conditional_code.h"

#include <gtest/gtest.h>

namespace tzc::rewriter::test {
namespace {

/// Whether the conditional that begins at the line of "other" excludes what stands at "here".
bool excluded(const std::string& text) {
  const ConditionalCode code(text);
  const std::size_t other = text.find("other"), begin = text.rfind('#', other), end = text.find('#', other);
  return code.excludes({begin, end}, text.find("here"));
}

TEST(ConditionalCode, branches_of_one_conditional) {
  EXPECT_TRUE(excluded("#if A == 1\nhere;\n#else\nother;\n#endif\n"));
  EXPECT_TRUE(excluded("#if A == 1\nhere;\n#elif A == 2\n#else\nother;\n#endif\n"));
  EXPECT_TRUE(excluded("#if A == 1\nother;\n#elif A == 2\nhere;\n#endif\n"));
  EXPECT_TRUE(
      excluded("#define A 1\n#ifdef A\n#ifdef B\nhere;\n#endif\n#else\n#ifdef C\nother;\n#endif\n#endif\n"));
}

TEST(ConditionalCode, conditions_that_contradict_each_other) {
  EXPECT_TRUE(excluded("#ifdef A\nhere;\n#endif\n#ifndef A\nother;\n#endif\n"));
  EXPECT_TRUE(excluded("#ifndef A\nhere;\n#endif\n#if defined A\nother;\n#endif\n"));
  EXPECT_TRUE(excluded("#if defined ( A ) && B > 2\nhere;\n#endif\n#if C && !defined(A)\nother;\n#endif\n"));
  EXPECT_TRUE(excluded("#if A > 1\n#else\nhere;\n#endif\n#if A > 1\nother;\n#endif\n"));
  EXPECT_TRUE(excluded("#if A || B\nhere;\n#endif\n#if A || B\n#else\nother;\n#endif\n"));
  EXPECT_TRUE(excluded("#ifdef A\n#elif defined(B)\nhere;\n#endif\n#ifdef A\nother;\n#endif\n"));
}

TEST(ConditionalCode, a_header_between_two_conditions_may_change_the_macro) {
  EXPECT_FALSE(excluded("#ifdef A\nhere;\n#include <x.h>\n#endif\n#ifndef A\nother;\n#endif\n"));
  EXPECT_FALSE(excluded("#ifdef A\nother;\n#endif\n# include_next <x.h>\n#ifndef A\nhere;\n#endif\n"));
  EXPECT_TRUE(
      excluded("#include <x.h>\n#ifdef A\nhere;\n#endif\n#ifndef A\nother;\n#include <y.h>\n#endif\n"));
  EXPECT_TRUE(excluded("#ifdef A\n#include <x.h>\nhere;\n#else\nother;\n#endif\n"));
}

TEST(ConditionalCode, conditions_that_may_both_hold) {
  EXPECT_FALSE(excluded("#ifdef A\nhere;\n#endif\n#ifdef B\nother;\n#endif\n"));
  EXPECT_FALSE(excluded("#ifdef A\nhere;\n#endif\n#ifdef A\nother;\n#endif\n"));
  EXPECT_FALSE(excluded("#if A && B\n#else\nhere;\n#endif\n#if A\nother;\n#endif\n"));
  EXPECT_FALSE(excluded("#if A || B\nhere;\n#endif\n#ifndef A\nother;\n#endif\n"));
  EXPECT_FALSE(excluded("here;\n#ifdef A\nother;\n#endif\n"));
  EXPECT_FALSE(excluded("#ifdef A\nhere;\n#ifdef B\nother;\n#endif\n#endif\n"));
  EXPECT_FALSE(excluded("#ifdef A\n#ifdef B\nhere;\n#endif\nother;\n#endif\n"));
}

TEST(ConditionalCode, a_macro_that_the_file_changes_says_nothing) {
  EXPECT_FALSE(excluded("#ifdef A\nhere;\n#undef A\n#endif\n#ifndef A\nother;\n#endif\n"));
  EXPECT_FALSE(excluded("#ifndef A\n#define A(x) x\nhere;\n#endif\n#ifdef A\nother;\n#endif\n"));
}

TEST(ConditionalCode, a_class_is_defined_once) {
  const auto both = [](const std::string& one, const std::string& two) {
    return excluded("#ifdef A\n" + one + "here;\n#endif\n#ifdef B\n" + two + "other;\n#endif\n");
  };
  EXPECT_TRUE(both("class X {\n};\n", "class X : public Y<Z> {\n int x;\n};\n"));
  EXPECT_TRUE(both("namespace a { struct API X final { void f() { } }; }\n",
                   "namespace a\n{\nnamespace { int i; }\nclass X { };\n}\n"));
  EXPECT_TRUE(both("namespace a::b { template <class T> class X { }; }\n",
                   "namespace a::b { template <typename U> struct X : U { }; }\n"));
  EXPECT_FALSE(both("class X;\n", "class X { };\n"));
  EXPECT_FALSE(both("class X { };\n", "namespace a { class X { }; }\n"));
  EXPECT_FALSE(both("struct X { };\n", "template <> struct X<int> { };\n"));
  EXPECT_FALSE(both("struct X { };\n", "struct Y::X { };\n"));
  EXPECT_FALSE(both("struct X { };\n", "struct X* f() { return 0; }\n"));
  EXPECT_FALSE(both("struct X { };\n", "void f() { struct X { }; }\n"));
  EXPECT_FALSE(both("struct X { };\n", "class Y { struct X { }; };\n"));
  EXPECT_FALSE(both("enum X { };\n", "enum X { };\n"));
}

TEST(ConditionalCode, a_class_in_an_inner_conditional_says_nothing_of_what_is_around_it) {
  EXPECT_FALSE(excluded(
      "#ifdef A\nhere;\n#ifdef C\nclass X { };\n#endif\n#endif\n#ifdef B\nclass X { };\nother;\n#endif\n"));
  EXPECT_FALSE(excluded(
      "#ifdef A\nclass X { };\nhere;\n#endif\n#ifdef B\nother;\n#ifdef C\nclass X { };\n#endif\n#endif\n"));
  EXPECT_FALSE(excluded("class X { };\nhere;\n#ifdef B\nclass X { };\nother;\n#endif\n"));
}

TEST(ConditionalCode, all_that_is_skipped_must_be_excluded) {
  const std::string text = "#ifdef A\na;\n#elif defined(B)\nb;\n#else\nhere;\n#endif\n#ifdef A\nc;\n#endif\n";
  const ConditionalCode code(text);
  EXPECT_TRUE(code.excludes({0, text.find("#else")}, text.find("here")));
  EXPECT_FALSE(code.excludes({0, text.size()}, text.find("here")));
  EXPECT_FALSE(code.excludes({text.find("b;"), text.find("b;")}, text.find("here")));
}

TEST(ConditionalCode, text_that_is_not_balanced_ends) {
  for (const char* text :
       {"#endif\n#else\n#elif A\n}}}", "#if A\n{{{ #", "#", "#if", "class X {", "#define", "#if A \\"})
    EXPECT_FALSE(ConditionalCode(text).excludes({0, 100}, 3)) << text;
}

}  // namespace
}  // namespace tzc::rewriter::test
