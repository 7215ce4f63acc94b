// SPDX-License-Identifier: BSD-3-Clause
// The language, where its rules surprise. All of it is compared with genmsg in oracle_test.py.
#include <gmock/gmock.h>

#include "library_case.h"
#include "parse/text.h"

namespace tzc::msggen::test {
namespace {

using ::testing::HasSubstr;

TEST(Fields, aliases_and_arrays) {
  LibraryCase c;
  c.file("A.msg", "byte b\nchar[] c\ntime[3] t\n");
  const auto& fields = c.good("A").fields;
  EXPECT_EQ(fields[0].builtin->cpp, "int8_t");
  EXPECT_EQ(fields[1].builtin->cpp, "uint8_t");
  EXPECT_EQ(fields[1].array, ArrayKind::variable);
  EXPECT_EQ(fields[2].length, 3u);
  EXPECT_EQ(fields[2].type, "time[3]");
}

TEST(Fields, header_alone_is_std_msgs_header_and_an_array_of_headers_is_not) {
  LibraryCase c;
  c.file("Header.msg", "uint8 own\n").file("A.msg", "Header[] mine\ndemo/Header one\n");
  EXPECT_EQ(c.good("A").fields[0].type, "demo/Header[]");
  c.file("B.msg", "Header header\n");
  c.library.find("demo/B");
  EXPECT_THAT(c.faults(), HasSubstr("unknown package 'std_msgs'"));
}

TEST(Fields, an_equals_sign_in_a_comment_makes_no_constant) {
  LibraryCase c;
  c.file("A.msg", "uint8 a # = 3\n");
  EXPECT_EQ(c.good("A").fields.size(), 1u);
}

TEST(Fields, blanks_and_tabs_around) {
  LibraryCase c;
  c.file("A.msg", " \tuint8  \t a\t\r\n\r\nuint8 b");
  EXPECT_EQ(c.good("A").fields.size(), 2u);
}

TEST(Constants, strings_keep_everything_to_the_end_of_line) {
  EXPECT_EQ(constant("string S=  a # b = c  ").value, "a # b = c");
  EXPECT_EQ(constant("string S=").value, "");
  EXPECT_EQ(constant("string  NAME  = \"quoted\"").name, "NAME");
}

TEST(Constants, numbers_as_python_reads_them) {
  EXPECT_EQ(constant("int32 A = -007 # James").value, "-7");
  EXPECT_EQ(constant("int32 A = -007").text, "-007");
  EXPECT_EQ(constant("uint32 A=1_000").value, "1000");
  EXPECT_EQ(constant("uint8 A=-0").value, "0");
  EXPECT_EQ(constant("int64 A=-9223372036854775808").value, "-9223372036854775808");
  EXPECT_EQ(constant("uint64 A=18446744073709551615").value, "18446744073709551615");
  EXPECT_EQ(constant("float32 A=1").value, "1.0");
  EXPECT_EQ(constant("float64 A=.5E-3").value, "0.0005");
  EXPECT_EQ(constant("bool A=True").value, "1");
  EXPECT_EQ(constant("bool A=0").value, "0");
}

TEST(Constants, booleans_are_literals_of_python) {
  for (const char* text :
       {"1", "0x1", "0X_f", "0b10", "0o7", "1.0", ".5", "1e3", "-1", "+2", "1_000", "01.5"})
    EXPECT_EQ(constant(std::string("bool A=") + text).value, "1") << text;
  for (const char* text : {"0", "00", "0x0", "0_0", "0.0", "-0", "0e9", "1e-400"})
    EXPECT_EQ(constant(std::string("bool A=") + text).value, "0") << text;
  for (const char* text :
       {"01", "0x", "0xg", "1__0", "_1", "1_", "0_x1", "true", "1.0.0", "--1", "0b2", "1e", ""}) {
    LibraryCase c;
    c.file("A.msg", std::string("bool A=") + text);
    EXPECT_FALSE(c.library.find("demo/A")) << text;
  }
}

TEST(Constants, may_begin_with_underscores_and_fields_may_not) {
  EXPECT_EQ(constant("uint8 _RESERVED=3").name, "_RESERVED");
  EXPECT_EQ(constant("string __s=x").name, "__s");
  for (const char* text : {"uint8 _field", "uint8 _a-b=1", "uint8 1A=1"}) {
    LibraryCase c;
    c.file("A.msg", text);
    EXPECT_FALSE(c.library.find("demo/A")) << text;
  }
}

TEST(Services, text_after_a_second_separator_belongs_to_the_response) {
  LibraryCase c;
  c.file("Ask.srv", "uint8 a\n--- comment\nuint8 b\n---\nuint8 c\n");
  EXPECT_EQ(c.good("AskRequest").fields.size(), 1u);
  EXPECT_EQ(c.good("AskResponse").fields.size(), 2u);
  EXPECT_EQ(c.good("AskResponse").text, "uint8 b\nuint8 c\n\n");
  EXPECT_EQ(c.library.services()[0].full_name(), "demo/Ask");
}

TEST(Actions, seven_messages) {
  LibraryCase c;
  c.file("Go.action", "uint8 g\n---\nuint8 r\n---\nuint8 f\n");
  for (const char* name : {"GoGoal", "GoResult", "GoFeedback"})
    EXPECT_EQ(c.good(name).fields.size(), 1u) << name;
  for (const char* name : {"GoAction", "GoActionGoal", "GoActionResult", "GoActionFeedback"}) {
    EXPECT_FALSE(c.library.find(std::string("demo/") + name)) << name << " needs actionlib_msgs";
  }
  EXPECT_THAT(c.faults(), HasSubstr("unknown package 'actionlib_msgs'"));
}

TEST(Resolution, a_chain_of_messages_may_be_long_but_not_endless) {
  LibraryCase c;
  for (int i = 0; i < 150; ++i)
    c.file("M" + std::to_string(i) + ".msg", "M" + std::to_string(i + 1) + " m\n");
  c.file("M150.msg", "uint8 end\n");
  EXPECT_TRUE(c.library.find("demo/M120")) << c.faults();
  EXPECT_FALSE(c.library.find("demo/M0"));
  EXPECT_THAT(c.faults(), HasSubstr("nested more than"));
}

TEST(Resolution, doubling_definitions_end) {
  LibraryCase c;
  c.file("M0.msg", "uint8[] data\n");
  for (int i = 1; i < 60; ++i) {
    const std::string inner = "M" + std::to_string(i - 1);
    c.file("M" + std::to_string(i) + ".msg", inner + " a\n" + inner + " b\n");
  }
  EXPECT_FALSE(c.library.find("demo/M59"));
  EXPECT_THAT(c.faults(), HasSubstr("has more than 10000 arrays inside"));
}

TEST(Text, strip_is_pythons) {
  EXPECT_EQ(strip(" \t\v\f\x1c\xC2\xA0x\xE3\x80\x80\n"), "x");
  EXPECT_EQ(strip("\xE2\x80\x8B"
                  "x"),
            "\xE2\x80\x8B"
            "x")
      << "a zero width space is no space";
  EXPECT_EQ(strip(" \xC2\x85 "), "");
}

TEST(Text, utf8) {
  EXPECT_EQ(find_invalid_utf8("gr\xC3\xBC\xC3\x9F \xF0\x9F\xA4\x96"), std::string_view::npos);
  EXPECT_EQ(find_invalid_utf8("a\xC0\x80"), 1u) << "overlong";
  EXPECT_EQ(find_invalid_utf8("\xED\xA0\x80"), 0u) << "a surrogate";
  EXPECT_EQ(find_invalid_utf8("ab\xE2\x82"), 2u) << "cut";
  EXPECT_EQ(with_replacements(std::string_view("a\0\xFF\xC3\xBC", 5)), "a??\xC3\xBC");
}

TEST(Text, nearest_name) {
  EXPECT_EQ(nearest("Pointt", {"Pose", "Point", "Point32"}), "Point");
  EXPECT_EQ(nearest("pointcloud2", {"PointCloud", "PointCloud2"}), "PointCloud2");
  EXPECT_EQ(nearest("Zebra", {"Point", "Pose"}), "");
}

}  // namespace
}  // namespace tzc::msggen::test
