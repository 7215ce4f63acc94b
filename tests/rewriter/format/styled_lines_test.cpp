// SPDX-License-Identifier: BSD-3-Clause
// Files that are not written as their .clang-format says: what no edit touched stays, and so does the indentation.
#include <gtest/gtest.h>

#include <random>
#include <set>
#include <sstream>

#include "edits/diff.h"
#include "format/format.h"
#include "support/temp_dir.h"

namespace tzc::rewriter {
namespace {

std::string styled(const std::string& style, const std::string& before, const std::string& after) {
  tzc::test::TempDir package;
  package.write(".clang-format", style);
  return format_changes(package / "src/a.cpp", before, after);
}

const char* four_columns = "{BasedOnStyle: Google, IndentWidth: 4, ColumnLimit: 80}";

TEST(StyledLines, a_file_with_another_indentation_keeps_it) {
  const std::string after =
      "void f() {\n"
      "  tzc::sensor_msgs::Image image;\n"
      "  pub.allocate(image);\n"
      "  image.data.resize(9);\n"
      "  pub.publish(image);\n"
      "}\n\n"
      "class C {\n"
      "  int i;\n"
      "  tzc::Publisher pub;\n"
      "};\n";
  EXPECT_EQ(styled(four_columns,
                   "void f() {\n"
                   "  sensor_msgs::Image image;\n"
                   "  image.data.resize(9);\n"
                   "  pub.publish(image);\n"
                   "}\n\n"
                   "class C {\n"
                   "  int i;\n"
                   "  ros::Publisher pub;\n"
                   "};\n",
                   after),
            after);
}
TEST(StyledLines, a_body_without_braces_keeps_its_indentation_and_its_continuation_follows) {
  EXPECT_EQ(
      styled(four_columns,
             "void f() {\n"
             "  if (debug)\n"
             "    image_pub_ = nh.advertise<sensor_msgs::Image>(\"image\", 1);\n"
             "  g();\n"
             "}\n",
             "void f() {\n"
             "  if (debug)\n"
             "    image_pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh, \"a/long/name/of/image\", 1);\n"
             "  g();\n"
             "}\n"),
      "void f() {\n"
      "  if (debug)\n"
      "    image_pub_ = tzc::advertise<tzc::sensor_msgs::Image>(\n"
      "        nh, \"a/long/name/of/image\", 1);\n"
      "  g();\n"
      "}\n");
}
TEST(StyledLines, a_wrapped_line_stands_behind_its_bracket_where_that_is) {
  EXPECT_EQ(styled(four_columns, "void f() {\n  pub = nh.advertise<Image>(a_topic, its_queue_size);\n}\n",
                   "void f() {\n"
                   "  pub = tzc::advertise<tzc::Image>(node_handle, the_name_of_a_topic, its_queue_size);\n"
                   "}\n"),
            "void f() {\n"
            "  pub = tzc::advertise<tzc::Image>(node_handle, the_name_of_a_topic,\n"
            "                                   its_queue_size);\n"
            "}\n");
}
TEST(StyledLines, tabs_stay_tabs) {
  EXPECT_EQ(styled("{BasedOnStyle: Google, UseTab: Never}", "void f() {\n\tImage image;\n\tg(image);\n}\n",
                   "void f() {\n\ttzc::Image   image;\n\tg(image);\n}\n"),
            "void f() {\n\ttzc::Image image;\n\tg(image);\n}\n");
}
TEST(StyledLines, lines_that_continue_a_changed_one_otherwise_than_the_style_stay) {
  const std::string after =
      "void f() {\n  pub = tzc::advertise<tzc::Image>(nh,\n      topic,\n      10);\n}\n";
  EXPECT_EQ(
      styled(four_columns, "void f() {\n  pub = nh.advertise<Image>(\n      topic,\n      10);\n}\n", after),
      after);
}
TEST(StyledLines, an_empty_line_between_changed_ones_stays) {
  const std::string after = "void f() {\n  x = tzc::g(a,\n\n             tzc::b);\n}\n";
  EXPECT_EQ(styled(four_columns, "void f() {\n  x = g(a,\n\n        b);\n}\n", after), after);
}

/// A file whose blocks are indented by any width, with lines that are longer or shorter than the style has them.
class RandomFile {
 public:
  explicit RandomFile(unsigned seed) : random_(seed) {}

  void write(std::size_t indent, int depth) {
    for (std::size_t left = 1 + up_to(3); left > 0; --left) {
      const std::size_t kind = up_to(depth < 3 ? 5 : 3);
      if (kind < 3) {
        statement(indent);
      } else if (kind == 3) {
        line(indent, "// " + name());
      } else if (kind == 4) {
        line(indent, "if (" + name() + ")");
        statement(indent + 1 + up_to(5));
      } else {
        line(indent, "{");
        write(indent + up_to(5), depth + 1);
        line(indent, "}");
      }
    }
  }

  std::string before, after;

 private:
  std::size_t up_to(std::size_t most) { return random_() % (most + 1); }
  std::string name() { return std::string(1 + up_to(20), 'n'); }
  void line(std::size_t indent, const std::string& text) {
    before += std::string(indent, ' ') + text + "\n";
    after += std::string(indent, ' ') + text + "\n";
  }

  void statement(std::size_t indent) {
    const std::string gap(indent, ' ');
    const std::string arguments =
        name() + ",  " + name() + (up_to(2) == 0 ? ",\n" + gap + "  " : ", ") + name();
    const std::string publisher = name();
    before += gap + publisher + "  = f(" + arguments + ");\n";
    if (up_to(2) == 0) {
      after += gap + publisher + "  = tzc::changed<tzc::" + name() + ">(" + arguments + ");\n";
      if (up_to(1) == 0) after += gap + publisher + ".allocate(" + name() + ");\n";
    } else {
      after += gap + publisher + "  = f(" + arguments + ");\n";
    }
  }

  std::mt19937 random_;
};

/// The lines that both have, in their order.
std::string common_lines(const std::string& before, const std::string& after) {
  std::string lines;
  for (const DiffLine& line : diff_lines(before, after))
    if (line.change == LineChange::same) lines += line.text;
  return lines;
}

/// With their indentation, the first words of the lines that the edits wrote.
std::set<std::string> begins_of_statements(const std::string& text) {
  std::set<std::string> begins;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);)
    if (line.find("tzc::changed") != std::string::npos || line.find(".allocate") != std::string::npos)
      begins.insert(line.substr(0, line.find_first_of(".=", line.find('n'))));
  return begins;
}

TEST(StyledLines, whatever_the_file_looks_like_no_other_line_changes_and_no_statement_moves) {
  const std::set<std::string> styles{
      four_columns, "BasedOnStyle: LLVM", "{BasedOnStyle: Google, UseTab: Always, TabWidth: 4}",
      "{BasedOnStyle: Mozilla, BreakBeforeBraces: Allman, ColumnLimit: 60, IndentWidth: 8}",
      "{BasedOnStyle: WebKit, ColumnLimit: 50, AllowShortIfStatementsOnASingleLine: AllIfsAndElse}"};
  for (unsigned seed = 0; seed < 100; ++seed)
    for (const std::string& style : styles) {
      RandomFile file(seed);
      file.write(0, 0);
      const std::string text = styled(style, file.before, file.after);
      ASSERT_EQ(common_lines(text, common_lines(file.before, file.after)),
                common_lines(file.before, file.after))
          << "seed " << seed << "\n"
          << style << "\n"
          << file.after << text;
      for (const std::string& begin : begins_of_statements(file.after))
        ASSERT_NE(("\n" + text).find("\n" + begin.substr(0, begin.find_last_not_of(' ') + 1)),
                  std::string::npos)
            << "seed " << seed << "\n"
            << style << "\n"
            << file.after << text;
    }
}

}  // namespace
}  // namespace tzc::rewriter
