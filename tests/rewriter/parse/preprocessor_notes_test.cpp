// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "parse/parse.h"
#include "support/temp_dir.h"

namespace tzc::rewriter {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::UnorderedElementsAre;

/// What the preprocessor did to a source.
class Preprocessed {
 public:
  explicit Preprocessed(std::string code, std::vector<std::string> options = {}) : code_(std::move(code)) {
    const tzc::test::TempDir folder;
    CompileUnit unit{folder.write("node.cpp", code_), folder.path(), {"c++", "-std=c++17"}};
    unit.arguments.insert(unit.arguments.end(), options.begin(), options.end());
    unit.arguments.push_back(unit.file);
    const ParseResult parsed = parse(unit, {}, [](clang::ASTContext&) {});
    EXPECT_TRUE(parsed.errors.empty()) << parsed.errors.front().text;
    notes_ = parsed.preprocessor;
  }

  std::vector<std::string> dropped() const { return texts_of(notes_.dropped); }
  std::vector<std::string> texts() const { return texts_of(notes_.texts); }
  std::vector<std::string> skipped() const { return texts_of(notes_.skipped); }
  bool keeps(const std::string& argument) const {
    for (const ArgumentPlace& place : notes_.kept)
      if (code_.compare(place.second, argument.size(), argument) == 0) return true;
    return false;
  }

 private:
  std::vector<std::string> texts_of(const std::vector<Place>& places) const {
    std::vector<std::string> texts;
    for (const Place& place : places) texts.push_back(code_.substr(place.begin, place.end - place.begin));
    return texts;
  }

  std::string code_;
  PreprocessorNotes notes_;
};

TEST(PreprocessorNotes, an_argument_that_a_macro_drops) {
  const Preprocessed source(
      "#define DROP(a)\n#define KEEP(a) a\nint one = 1;\nvoid f() { DROP(one + 2); KEEP(one); }\n");
  EXPECT_THAT(source.dropped(), ElementsAre("one + 2"));
  EXPECT_TRUE(source.keeps("one); }"));
}

TEST(PreprocessorNotes, what_a_macro_within_a_macro_drops) {
  const Preprocessed source(
      "#define DROP(a) ((void)0)\n#define CHECK(a, b) DROP((a) == 1), (void)(b)\n"
      "void f(int one, int two) { CHECK(one, two); }\n");
  EXPECT_THAT(source.dropped(), ElementsAre("one"));
  EXPECT_TRUE(source.keeps("two);"));
}

TEST(PreprocessorNotes, an_argument_that_a_macro_uses_twice_or_passes_on_is_kept) {
  const Preprocessed source(
      "#define INNER(a) (a)\n#define TWICE(...) INNER(__VA_ARGS__), INNER(__VA_ARGS__)\n"
      "void f(int one) { (void)(TWICE(one)); }\n");
  EXPECT_THAT(source.dropped(), IsEmpty());
  EXPECT_TRUE(source.keeps("one))"));
}

TEST(PreprocessorNotes, assert_drops_under_ndebug_alone) {
  const std::string code = "#include <cassert>\nvoid f(int one) { assert(one == 1); }\n";
  EXPECT_THAT(Preprocessed(code, {"-DNDEBUG"}).dropped(), ElementsAre("one == 1"));
  EXPECT_THAT(Preprocessed(code).dropped(), IsEmpty());
}

TEST(PreprocessorNotes, arguments_that_become_texts) {
  const Preprocessed source(
      "#define TEXT(a) #a\n#define FIELD(type, name) type name; const char* name##_type = #type\n"
      "#define LATER(a) TEXT(a)\n"
      "FIELD(unsigned long, size);\nconst char* later = LATER(x + y);\n");
  EXPECT_THAT(source.texts(), UnorderedElementsAre("unsigned long", "x + y"));
  EXPECT_THAT(source.dropped(), ElementsAre("x + y"));
}

TEST(PreprocessorNotes, branches_that_are_skipped) {
  const Preprocessed source("#ifdef NOT_DEFINED\nint a;\n#else\nint b;\n#endif\n");
  EXPECT_THAT(source.skipped(), ElementsAre("#ifdef NOT_DEFINED\nint a;\n#else"));
}

TEST(PreprocessorNotes, system_headers_do_not_count) {
  const Preprocessed source("#include <vector>\n#include <cassert>\n", {"-DNDEBUG"});
  EXPECT_THAT(source.dropped(), IsEmpty());
  EXPECT_THAT(source.texts(), IsEmpty());
}

}  // namespace
}  // namespace tzc::rewriter
