// SPDX-License-Identifier: BSD-3-Clause
// Where an include is written: with ROS's headers, whatever groups a file has.
#include "edits/includes.h"

#include <gtest/gtest.h>

#include "edits/apply.h"

namespace tzc::rewriter {
namespace {

/// The content with the header included, where all that the file has of `edited` is edited, too.
std::string with(const std::string& header, const std::string& content, const std::string& edited = "") {
  Edits others;
  for (std::size_t at = content.find(edited); !edited.empty() && at != std::string::npos;
       at = content.find(edited, at + 1)) {
    others.emplace_back();
    others.back().file = "node.cpp";
    others.back().offset = at;
    others.back().length = edited.size();
  }
  const Edits edits = include_edits({{"node.cpp", {header}}}, others,
                                    [&](const std::string&) { return std::optional(content); });
  return *apply_edits(content, edits);
}

TEST(Include, stands_with_ros_and_not_behind_the_last_group) {
  EXPECT_EQ(
      with("tzc/ros.h", "#include <ros/ros.h>\n#include <sensor_msgs/Image.h>\n\n#include <string>\n"),
      "#include <ros/ros.h>\n#include <sensor_msgs/Image.h>\n#include <tzc/ros.h>\n\n#include <string>\n");
}

TEST(Include, stands_before_a_foreign_header_of_the_same_group) {
  EXPECT_EQ(with("tzc/ros.h", "#include <ros/ros.h>\n#include <opencv2/core.hpp>\n"),
            "#include <ros/ros.h>\n#include <tzc/ros.h>\n#include <opencv2/core.hpp>\n");
}

TEST(Include, stands_in_the_condition_that_has_all_edits) {
  EXPECT_EQ(with("tzc/ros.h",
                 "#pragma once\n#include <a.h>\n#ifdef ROS1\n#include <ros/ros.h>\nint x;\n#endif\n", "x"),
            "#pragma once\n#include <a.h>\n#ifdef ROS1\n#include <ros/ros.h>\n#include <tzc/ros.h>\nint "
            "x;\n#endif\n");
}

TEST(Include, stands_in_the_branch_that_has_all_edits) {
  EXPECT_EQ(with("tzc/ros.h",
                 "#ifdef ROS2\n#include <rclcpp/rclcpp.hpp>\n#elif 1\n#include <ros/ros.h>\nint "
                 "x;\n#else\nint y;\n#endif\n",
                 "x"),
            "#ifdef ROS2\n#include <rclcpp/rclcpp.hpp>\n#elif 1\n#include <ros/ros.h>\n#include "
            "<tzc/ros.h>\nint x;\n#else\n"
            "int y;\n#endif\n");
}

TEST(Include, stands_outside_of_a_condition_that_lacks_an_edit) {
  EXPECT_EQ(with("tzc/ros.h", "#include <a.h>\n#ifdef ROS1\n#include <ros/ros.h>\n#endif\nint x;\n", "x"),
            "#include <a.h>\n#include <tzc/ros.h>\n#ifdef ROS1\n#include <ros/ros.h>\n#endif\nint x;\n");
  EXPECT_EQ(with("tzc/ros.h",
                 "#include <a.h>\n#ifdef ROS1\n#include <ros/ros.h>\nint x;\n#else\nint x;\n#endif\n", "x"),
            "#include <a.h>\n#include <tzc/ros.h>\n#ifdef ROS1\n#include <ros/ros.h>\nint x;\n#else\nint "
            "x;\n#endif\n");
}

TEST(Include, prefers_the_group_of_ros_h) {
  EXPECT_EQ(with("tzc/ros.h",
                 "#include <std_msgs/String.h>\n\n#include <ros/ros.h>\n#include <tf/tf.h>\n\nint x;\n"),
            "#include <std_msgs/String.h>\n\n#include <ros/ros.h>\n#include <tf/tf.h>\n#include "
            "<tzc/ros.h>\n\nint x;\n");
}

TEST(Include, takes_the_first_group_of_ros_when_none_has_ros_h) {
  EXPECT_EQ(
      with("tzc/ros.h", "#include <vector>\n\n#include <sensor_msgs/Image.h>\n\n#include <my_msgs/Own.h>\n"),
      "#include <vector>\n\n#include <sensor_msgs/Image.h>\n#include <tzc/ros.h>\n\n#include "
      "<my_msgs/Own.h>\n");
}

TEST(Include, of_a_twin_stands_behind_the_stock_header) {
  EXPECT_EQ(with("tzc/sensor_msgs/Image.h",
                 "#include <ros/ros.h>\n\n#include \"sensor_msgs/Image.h\"\n#include <a>\n"),
            "#include <ros/ros.h>\n\n#include \"sensor_msgs/Image.h\"\n#include "
            "<tzc/sensor_msgs/Image.h>\n#include <a>\n");
}

TEST(Include, without_any_of_ros_comes_last) {
  EXPECT_EQ(with("tzc/ros.h", "#include \"node.h\"\n#include <vector>\n\nint x;\n"),
            "#include \"node.h\"\n#include <vector>\n#include <tzc/ros.h>\n\nint x;\n");
}

TEST(Include, comments_are_no_code_whatever_they_look_like) {
  for (const char* banner :
       {"//****\n// Camera\n//****\n", "// see /camera/*\n", "/* a\n *//* b */\n", "/***/\n",
        "// a \\\n   /* b\n", "/*\n#include <z.h>\nint x;\n*/\n", "//* a\n"}) {
    const std::string top = banner;
    EXPECT_EQ(with("tzc/ros.h", top + "#include <ros/ros.h>\nint x;\n#include <b.h>\n"),
              top + "#include <ros/ros.h>\n#include <tzc/ros.h>\nint x;\n#include <b.h>\n");
    EXPECT_EQ(with("tzc/ros.h", top + "int x;\n"), top + "#include <tzc/ros.h>\nint x;\n");
    EXPECT_EQ(with("tzc/ros.h", top + "#ifndef A\n" + top + "#define A\n#include <ros/ros.h>\n#endif\n"),
              top + "#ifndef A\n" + top + "#define A\n#include <ros/ros.h>\n#include <tzc/ros.h>\n#endif\n");
  }
}

TEST(Include, what_is_in_a_string_is_no_comment) {
  EXPECT_EQ(with("tzc/ros.h", "#include \"/*.h\"\n#include <ros/ros.h>  // */\nint x;\n"),
            "#include \"/*.h\"\n#include <ros/ros.h>  // */\n#include <tzc/ros.h>\nint x;\n");
}

TEST(Include, stands_behind_a_comment_that_goes_on) {
  for (const char* comment :
       {"// C:\\share\\\n#define IT 1\n", "// \\ \n#include <no.h>\n", "// why\?\?/\nis that\n",
        "// a \\\r\n   b \\\r\n   c\r\n", "/* a\n b */\n", "/* a\n b\n*/ // c \\\n d\n", "\\\n\n"}) {
    const std::string line = std::string("#include <ros/ros.h>  ") + comment;
    EXPECT_EQ(with("tzc/ros.h", line + "int x;\n"), line + "#include <tzc/ros.h>\nint x;\n");
  }
}

TEST(Include, of_several_headers_stands_behind_a_directive_of_several_lines) {
  const std::string top = "#include <a.h>\n#define TWO(x) \\\n  x; \\\n  x\n";
  EXPECT_EQ(with("tzc/ros.h", top + "#include <ros/ros.h>\nint x;\n"),
            top + "#include <ros/ros.h>\n#include <tzc/ros.h>\nint x;\n");
}

TEST(Include, is_not_written_twice) {
  EXPECT_EQ(with("tzc/ros.h", "#include <tzc/ros.h>\n"), "#include <tzc/ros.h>\n");
}

}  // namespace
}  // namespace tzc::rewriter
