// SPDX-License-Identifier: BSD-3-Clause
// Files without a .clang-format: alignment and width stay as the author has them.
#include <gtest/gtest.h>

#include "format/continuations.h"
#include "format/line_width.h"

namespace tzc::rewriter {
namespace {

TEST(Continuations, move_with_their_bracket) {
  EXPECT_EQ(
      realigned(
          "p = nh.advertise<Image>(\"image\",\n                        10,\n                        cb);\n",
          "p = tzc::advertise<tzc::Image>(nh, \"image\",\n                        10,\n                      "
          "  cb);\n"),
      "p = tzc::advertise<tzc::Image>(nh, \"image\",\n                               10,\n"
      "                               cb);\n");
}
TEST(Continuations, of_an_inner_bracket_move_with_it) {
  EXPECT_EQ(realigned("a(b(1,\n    2),\n  3);\nc();\n", "long_a(b(1,\n    2),\n  3);\nc();\n"),
            "long_a(b(1,\n         2),\n       3);\nc();\n");
}
TEST(Continuations, that_are_not_aligned_stay) {
  const std::string after = "p = tzc::advertise<tzc::Image>(nh, \"image\",\n    10);\n";
  EXPECT_EQ(realigned("p = nh.advertise<Image>(\"image\",\n    10);\n", after), after);
}
TEST(Continuations, brackets_in_texts_and_comments_are_no_brackets) {
  const std::string after = "f(\"(\");  // (\n  g();\n";
  EXPECT_EQ(realigned("e(\"(\");  // (\n  g();\n", after), after);
}
TEST(Continuations, an_inserted_line_between_does_not_matter) {
  EXPECT_EQ(
      realigned("Image image;\nf(a,\n  b);\n", "tzc::Image image;\npub.allocate(image);\nlong_f(a,\n  b);\n"),
      "tzc::Image image;\npub.allocate(image);\nlong_f(a,\n       b);\n");
}
TEST(Continuations, with_tabs_stay) {
  const std::string after = "\tlong_f(a,\n\t  b);\n";
  EXPECT_EQ(realigned("\tf(a,\n\t  b);\n", after), after);
}
TEST(Continuations, of_other_statements_stay) {
  const std::string after = "long_f(a);\n  b();\n";
  EXPECT_EQ(realigned("f(a);\n  b();\n", after), after);
}

const std::string short_call =
    "void f( int x ) {\n    pub = nh.advertise<Image>(\"a_topic_name\", queue_size_of_it);\n}\n";
const std::string long_call =
    "void f( int x ) {\n"
    "    pub = tzc::advertise<tzc::sensor_msgs::Image>(node_handle, \"a_topic_name\", "
    "queue_size_of_it);\n}\n";

TEST(LineWidth, a_line_beyond_it_is_broken_and_nothing_else_changes) {
  EXPECT_EQ(wrapped("a.cpp", short_call, long_call),
            "void f( int x ) {\n"
            "    pub = tzc::advertise<tzc::sensor_msgs::Image>(node_handle, \"a_topic_name\",\n"
            "                                                  queue_size_of_it);\n}\n");
}
TEST(LineWidth, an_indentation_of_the_files_own_stays) {
  const auto in_namespace = [](const std::string& text) {
    return "namespace n {\n   namespace m {\n" + text + "}\n}\n";
  };
  EXPECT_EQ(wrapped("a.cpp", in_namespace("      pub = nh.advertise<Image>(a_topic, its_queue_size);\n"),
                    in_namespace("      pub = tzc::advertise<tzc::sensor_msgs::Image>(node_handle, a_topic, "
                                 "its_queue_size);\n")),
            in_namespace("      pub = tzc::advertise<tzc::sensor_msgs::Image>(node_handle, a_topic,\n"
                         "                                                    its_queue_size);\n"));
}
TEST(LineWidth, is_what_the_file_has) {
  std::string wide;
  for (int i = 0; i < 20; ++i) wide += "// " + std::string(110, 'x') + "\n";
  EXPECT_EQ(wrapped("a.cpp", wide + short_call, wide + long_call), wide + long_call);
}
TEST(LineWidth, one_long_line_among_many_is_no_measure) {
  std::string before = "// " + std::string(150, 'x') + "\n";
  for (int i = 0; i < 100; ++i) before += "int x;\n";
  EXPECT_NE(wrapped("a.cpp", before + short_call, before + long_call), before + long_call);
}
TEST(LineWidth, lines_that_were_long_before_stay) {
  EXPECT_EQ(wrapped("a.cpp", long_call, long_call), long_call);
}
TEST(LineWidth, tabs_and_directives_are_not_broken) {
  for (const std::string& line : {"\tf(aaaaaaaaaa, " + std::string(80, 'b') + ");\n",
                                  "#define F f(aaaaaaaaaa, " + std::string(80, 'b') + ")\n"})
    EXPECT_EQ(wrapped("a.cpp", "", line), line);
}

}  // namespace
}  // namespace tzc::rewriter
