// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include "emit/header.h"
#include "library_case.h"
#include "model/md5.h"

namespace tzc::msggen::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

TEST(Md5, test_suite_of_rfc_1321) {
  EXPECT_EQ(md5_hex(""), "d41d8cd98f00b204e9800998ecf8427e");
  EXPECT_EQ(md5_hex("abc"), "900150983cd24fb0d6963f7d28e17f72");
  EXPECT_EQ(md5_hex("12345678901234567890123456789012345678901234567890123456789012345678901234567890"),
            "57edf4a22be3c955ac49da2e2107b67a");
  EXPECT_EQ(md5_hex(std::string(55, 'a')), "ef1772b6dff9a122358552954ad0df65");
  EXPECT_EQ(md5_hex(std::string(56, 'a')), "3b0c8ac703f828b04c6c197006d17218");
}

TEST(Md5, of_a_message_ignores_comments_and_names_of_packages) {
  LibraryCase c;
  c.file("A.msg", "# a comment\nuint8  x # more\nuint8 X = 1\n").file("B.msg", "uint8 X=1\nuint8 x\n");
  EXPECT_EQ(c.facts("A").md5, c.facts("B").md5);
  c.file("C.msg", "A a\n").file("D.msg", "demo/B a\n");
  EXPECT_EQ(c.facts("C").md5, c.facts("D").md5);
}

TEST(Classification, fixed_length) {
  LibraryCase c;
  c.file("A.msg", "float64[9] k\ntime t\n")
      .file("B.msg", "A[4] a\n")
      .file("C.msg", "string s\n")
      .file("D.msg", "");
  EXPECT_TRUE(c.facts("A").fixed_length && c.facts("B").fixed_length && c.facts("D").fixed_length);
  EXPECT_FALSE(c.facts("C").fixed_length || c.facts("C").has_variable_array);
  EXPECT_EQ(c.facts("B").wire_size, 4u * 80);
}

TEST(Classification, variable_arrays_of_fixed_length_types_are_data_at_any_depth) {
  LibraryCase c;
  c.file("Point.msg", "float32 x\n").file("Channel.msg", "string name\nfloat32[] values\n");
  c.file("Cloud.msg", "Point[] points\nChannel[] channels\nChannel[2] pair\nChannel one\nstring[] notes\n");
  EXPECT_THAT(c.facts("Cloud").data_fields,
              ElementsAre("points", "channels[].values", "pair[2].values", "one.values"));
  EXPECT_TRUE(c.facts("Cloud").has_data_part() && c.facts("Cloud").has_variable_array);
}

TEST(Classification, needs_support_but_has_no_data_part) {
  LibraryCase c;
  c.file("Names.msg", "string[] names\n").file("Outer.msg", "Names inner\n");
  EXPECT_TRUE(c.facts("Outer").has_variable_array);
  EXPECT_THAT(c.facts("Outer").data_fields, IsEmpty());
}

TEST(Layout, padding_is_in_memory_only) {
  LibraryCase c;
  c.file("F.msg", "uint8 type\nuint8 id\nfloat32 intensity\n").file("G.msg", "F[3] f\nfloat64 d\nuint8 e\n");
  EXPECT_EQ(c.facts("F").wire_size, 6u);
  EXPECT_EQ(c.facts("F").memory.size, 8u);
  EXPECT_EQ(c.facts("G").wire_size, 27u);
  EXPECT_EQ(c.facts("G").memory.size, 40u);
}

TEST(FullText, nested_types_once_each_in_depth_first_order) {
  LibraryCase c;
  c.file("A.msg", "B b\nC c\n").file("B.msg", "D d").file("C.msg", "D d\n").file("D.msg", "uint8 x\n");
  const std::string line = std::string(80, '=') + "\n";
  EXPECT_EQ(c.library.analysis().full_text(c.good("A")), "B b\nC c\n\n" + line + "MSG: demo/B\nD d\n" + line +
                                                             "MSG: demo/D\nuint8 x\n\n" + line +
                                                             "MSG: demo/C\nD d\n");
}

TEST(Headers, extreme_constants_are_legal_literals) {
  LibraryCase c;
  c.file("A.msg",
         "int64 LEAST=-9223372036854775808\nfloat64 N=nan\nfloat32 I=-inf\nstring S=?\?/ \\ \"\nuint8[] x\n");
  const std::string text = emit_message(c.good("A"), c.library.analysis()).text;
  EXPECT_THAT(text, HasSubstr("LEAST = -9223372036854775807 - 1,"));
  EXPECT_THAT(text, HasSubstr("::N = ::std::numeric_limits<double>::quiet_NaN();"));
  EXPECT_THAT(text, HasSubstr("::I = -::std::numeric_limits<float>::infinity();"));
  EXPECT_THAT(text, HasSubstr(R"(::S = "\?\?/ \\ \"";)"));
}

}  // namespace
}  // namespace tzc::msggen::test
