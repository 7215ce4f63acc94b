// SPDX-License-Identifier: BSD-3-Clause
// Files without a .clang-format: alignment and width stay as the author has them.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <sstream>

#include "format/brackets.h"
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
TEST(LineWidth, a_line_behind_a_bracket_moves_with_it) {
  const std::string before =
      "pub =\n"
      "    nh.advertise<Image>(\"a_topic_name\", bind(&Node::is_connected, this),\n"
      "                        bind(&Node::is_gone, this));\n";
  const std::string after =
      "pub =\n"
      "    tzc::advertise<Image>(node_handle, \"a_topic_name\", bind(&Node::is_connected, this),\n"
      "                          bind(&Node::is_gone, this));\n";
  EXPECT_EQ(wrapped("a.cpp", before, after),
            "pub = tzc::advertise<Image>(node_handle, \"a_topic_name\",\n"
            "                            bind(&Node::is_connected, this),\n"
            "                            bind(&Node::is_gone, this));\n");
}
TEST(LineWidth, two_lines_of_a_statement_are_broken_as_one) {
  const std::string filler(40, 'x');
  EXPECT_EQ(wrapped("a.cpp", "",
                    "pub = tzc::advertise<tzc::sensor_msgs::LaserScan>(nh, \"scan\", 10, bind(&" + filler +
                        "),\n                                                  bind(&" + filler + "));\n"),
            "pub = tzc::advertise<tzc::sensor_msgs::LaserScan>(\n    nh, \"scan\", 10, bind(&" + filler +
                "),\n    bind(&" + filler + "));\n");
}
TEST(LineWidth, lines_behind_a_comment_belong_to_the_statement) {
  EXPECT_EQ(
      wrapped("a.cpp", "",
              "int n;\n"
              "  scan_publisher_ = tzc::advertise<tzc::sensor_msgs::LaserScan>(nh, \"scan\",  // where\n"
              "                                                                10);  // and how many\n"),
      "int n;\n"
      "  scan_publisher_ =\n"
      "      tzc::advertise<tzc::sensor_msgs::LaserScan>(nh, \"scan\",  // where\n"
      "                                                  10);  // and how many\n");
}
TEST(LineWidth, a_literal_is_not_broken) {
  const std::string line =
      "pub = advertise(\"" + std::string(50, 'a') + " " + std::string(50, 'b') + "\");\n";
  EXPECT_EQ(wrapped("a.cpp", "", line).find("\" \""), std::string::npos);
  EXPECT_NE(wrapped("a.cpp", "", line).find("a b"), std::string::npos);
}

/// Calls with arguments of any length, some of them calls, whose lines stand behind a bracket or end with one, or a comment.
class RandomCall {
 public:
  explicit RandomCall(unsigned seed) : random_(seed) {}

  std::string text(std::size_t indent) {
    text_ = std::string(indent, ' ') + name() + " = ";
    call(0);
    return text_ + ";\n";
  }

 private:
  std::size_t up_to(std::size_t most) { return random_() % (most + 1); }
  std::string line_break() { return up_to(3) == 0 ? ",  // (" + name() + "\n" : ",\n"; }
  std::string name() { return std::string(1 + up_to(30), 'n'); }

  void call(int depth) {
    text_ += name() + "(";
    const std::size_t column = text_.size() - (text_.rfind('\n') + 1);
    for (std::size_t left = up_to(4) + 1; left > 0; --left) {
      if (depth < 2 && up_to(2) == 0)
        call(depth + 1);
      else
        text_ += name();
      if (left > 1) text_ += up_to(1) == 0 ? ", " : line_break() + std::string(column, ' ');
    }
    text_ += ")";
  }

  std::mt19937 random_;
  std::string text_;
};

std::string without_blanks(std::string text) {
  text.erase(std::remove_if(text.begin(), text.end(), [](char c) { return c == ' ' || c == '\n'; }),
             text.end());
  return text;
}

void expect_well_formed(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::size_t> open;
  bool ended_with_bracket = false;
  for (std::string line; std::getline(stream, line);) {
    ASSERT_FALSE(line.empty() || line.back() == ' ') << text;
    if (!open.empty() && !ended_with_bracket) {
      ASSERT_EQ(line.find_first_not_of(' '), open.back() + 1) << text;
    }
    const Brackets brackets = brackets_of(line);
    ASSERT_LE(brackets.closed, open.size()) << text;
    open.resize(open.size() - brackets.closed);
    open.insert(open.end(), brackets.open.begin(), brackets.open.end());
    ended_with_bracket =
        ended_with_bracket || line.back() == '(';  // from there on the indentation is clang-format's
  }
}

TEST(LineWidth, whatever_is_wide_is_aligned_when_it_was_and_leaves_no_blanks) {
  for (unsigned seed = 0; seed < 2000; ++seed) {
    const std::string after = "int n;\n" + RandomCall(seed).text(2 * (seed % 3));
    const std::string text = wrapped("a.cpp", "", after);
    ASSERT_EQ(without_blanks(text), without_blanks(after));
    ASSERT_NO_FATAL_FAILURE(expect_well_formed(text)) << "seed " << seed << "\n" << after;
  }
}

}  // namespace
}  // namespace tzc::rewriter
