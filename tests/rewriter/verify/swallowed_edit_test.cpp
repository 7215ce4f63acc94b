// SPDX-License-Identifier: BSD-3-Clause
// Whether an edited text says what its edits mean.
#include "verify/swallowed_edit.h"

#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

#include "edits/apply.h"

namespace tzc::rewriter {
namespace {

Edit edit_at(std::size_t offset, std::size_t length, const std::string& text) {
  Edit edit;
  edit.file = "node.cpp";
  edit.offset = offset;
  edit.length = length;
  edit.text = text;
  return edit;
}

/// Edits the place that `|` marks, or replaces what stands between two of them.
bool is_swallowed(std::string marked, const std::string& written) {
  const std::size_t begin = marked.find('|');
  marked.erase(begin, 1);
  const std::size_t end = marked.find('|');
  if (end != std::string::npos) marked.erase(end, 1);
  const Edits edits{edit_at(begin, end == std::string::npos ? 0 : end - begin, written)};
  return swallowed_edit(marked, edits, *apply_edits(marked, edits)).has_value();
}

TEST(SwallowedEdit, code_among_code_is_not_swallowed) {
  EXPECT_FALSE(is_swallowed("Image image;\n|pub.publish(image);", "pub.allocate(image);\n"));
  EXPECT_FALSE(is_swallowed("Image image;  // a comment|\npub.publish(image);", "\npub.allocate(image);"));
  EXPECT_FALSE(is_swallowed("|ros::Publisher| pub;", "tzc::Publisher"));
  EXPECT_FALSE(is_swallowed("std::vector<|Ptr|>x;", "std::shared_ptr<Image>")) << "the two > are one token";
  EXPECT_FALSE(is_swallowed("auto text = R\"(// no comment)\";|\n", " use(text);"));
}

TEST(SwallowedEdit, a_comment_swallows) {
  EXPECT_TRUE(is_swallowed("Image image;  // in C:\\\n|pub.publish(image);", "pub.allocate(image);\n"));
  EXPECT_TRUE(is_swallowed("Image image;  // a comment|\npub.publish(image);", " pub.allocate(image);"));
  EXPECT_TRUE(is_swallowed("/* Image |image; */ run();", "tzc::"));
}

TEST(SwallowedEdit, an_edit_swallows) {
  EXPECT_TRUE(is_swallowed("int a;| int b;", "  // an edit"));
  EXPECT_TRUE(is_swallowed("int a;| int b;", "/*"));
  EXPECT_TRUE(is_swallowed("auto| x = 1;", "matic"));
}

TEST(SwallowedEdit, a_string_swallows) {
  EXPECT_TRUE(is_swallowed("auto text = \"ros::|Publisher\";", "x "));
  EXPECT_TRUE(is_swallowed("auto text = R\"(\n|)\";", "pub.allocate(image);\n"));
}

TEST(SwallowedEdit, a_directive_is_no_code) {
  EXPECT_TRUE(is_swallowed("#define PUBLISH pub.publish(image)|\nrun();", "; pub.allocate(image)"));
  EXPECT_TRUE(is_swallowed("int a;\n|int b;", "#include <tzc/ros.h> "));
  EXPECT_FALSE(is_swallowed("int a;\n|int b;", "#include <tzc/ros.h>\n"));
  EXPECT_FALSE(is_swallowed("#include |<ros/ros.h>|\nint a;", "<tzc/ros.h>"))
      << "the directive itself is edited";
  EXPECT_FALSE(is_swallowed("#define PUB |ros|::Publisher\nint a;", "tzc"));
}

TEST(SwallowedEdit, names_the_edit) {
  const std::string text = "int a;\nint b;  // in C:\\\nint c;\nint d;\n";
  const std::size_t inside = text.find("int c"), after = text.find("int d");
  const Edits edits{edit_at(0, 0, "int x;\n"), edit_at(inside, 0, "int y;\n"), edit_at(after, 0, "int z;\n")};
  const std::optional<Edit> found = swallowed_edit(text, edits, *apply_edits(text, edits));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->text, "int y;\n");
}

/// Pieces of sources, each of which ends where code may begin.
const std::vector<std::string> code_pieces = {"run();",
                                              "int a = 1;\n",
                                              "// a comment\n",
                                              "/* a\n comment */",
                                              "auto s = \"// \\\" |\";",
                                              "char c = '\"';\n",
                                              "x >> y; ",
                                              "f(R\"x(/* )\" )x\");",
                                              "\n#if 0\n\n",
                                              "\n#endif\n",
                                              "#define A(x) \\\n  x\n",
                                              "\r\n",
                                              "t<u<v>>w;"};
/// Pieces that swallow what follows them on their line or the next one.
const std::vector<std::string> swallowing_pieces = {"// a comment ", "\n// \\\n", "/* ",
                                                    "\n#define A ",  "\"",        "R\"(\n"};

TEST(SwallowedEdit, found_behind_whatever_swallows_and_nowhere_else) {
  std::mt19937 random(20261130);
  const auto any_of = [&random](const std::vector<std::string>& pieces) {
    return pieces[random() % pieces.size()];
  };
  for (int round = 0; round < 3000; ++round) {
    std::string text;
    for (unsigned pieces = random() % 6; pieces > 0; --pieces) text += any_of(code_pieces);
    if (!text.empty() && text.back() != '\n') text += "\n";
    const bool swallows = random() % 2 != 0;
    if (swallows) text += any_of(swallowing_pieces);
    const Edits edits{edit_at(text.size(), 0, "pub.allocate(image);\n")};
    text += any_of(code_pieces);
    const bool found = swallowed_edit(text, edits, *apply_edits(text, edits)).has_value();
    ASSERT_EQ(found, swallows) << text << "\nedited at " << edits[0].offset;
  }
}

}  // namespace
}  // namespace tzc::rewriter
