// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "buildfiles/cmake_file.h"
#include "buildfiles/cmake_values.h"
#include "buildfiles/xml_scanner.h"

namespace tzc::rewriter {
namespace {

/// "name(arg|arg) name(...)", or the error.
std::string cmake(const std::string& text) {
  const auto commands = parse_cmake(text, "f");
  if (!commands) return commands.error().where + ": " + commands.error().what;
  std::string out;
  for (const CmakeCommand& command : *commands) {
    out += (out.empty() ? "" : " ") + command.name + "(";
    for (std::size_t i = 0; i < command.arguments.size(); ++i)
      out += (i ? "|" : "") + command.arguments[i].text;
    out += ")";
  }
  return out;
}

TEST(ParseCmake, commands_and_arguments) {
  EXPECT_EQ(cmake("A(b c)\nd ( e )"), "a(b|c) d(e)");
}
TEST(ParseCmake, a_byte_order_mark_is_no_command) {
  EXPECT_EQ(cmake("\xEF\xBB\xBFproject(demo)"), "project(demo)");
}
TEST(ParseCmake, quotes) {
  EXPECT_EQ(cmake("set(X \"a b) # \\\" c\" d)"), "set(X|a b) # \\\" c|d)");
}
TEST(ParseCmake, comments) {
  EXPECT_EQ(cmake("# a(b\nset(X # y)\n z)"), "set(X|z)");
}
TEST(ParseCmake, bracket_comments_and_arguments) {
  EXPECT_EQ(cmake("#[[ a( ]] set(X [=[ ]] ) ]=] y)"), "set(X| ]] ) |y)");
}
TEST(ParseCmake, nested_parentheses) {
  EXPECT_EQ(cmake("if((A) AND (B OR C)) endif()"), "if(A|AND|B|OR|C) endif()");
}
TEST(ParseCmake, quotes_inside_an_unquoted_argument) {
  EXPECT_EQ(cmake("f(-Da=\"b c\" d)"), "f(-Da=\"b c\"|d)");
}
TEST(ParseCmake, offsets) {
  const auto commands = parse_cmake("set(X \"a\")", "f");
  ASSERT_TRUE(commands);
  EXPECT_EQ(commands->at(0).arguments[1].begin, 6u);
  EXPECT_EQ(commands->at(0).arguments[1].end, 9u);
  EXPECT_EQ(commands->at(0).close, 9u);
}
TEST(ParseCmake, what_is_left_open_is_an_error_with_its_line) {
  for (const char* text : {"\nset(X", "\nset(X \"a)", "\nset(X [[a)", "\nset X", "\n)"})
    EXPECT_EQ(cmake(text).substr(0, 4), "f:2:") << text;
}

CmakeValues learned(const std::string& text) {
  CmakeValues values;
  const auto commands = parse_cmake(text, "f");
  for (const CmakeCommand& command : *commands) values.learn(command);
  return values;
}
using Set = std::set<std::string>;

TEST(CmakeValues, project_name) {
  EXPECT_EQ(learned("project(cam CXX)").expand("${PROJECT_NAME}_node"), Set{"cam_node"});
}
TEST(CmakeValues, nested) {
  EXPECT_EQ(learned("project(cam)").expand("${${PROJECT_NAME}_EXPORTED_TARGETS}"),
            Set{"${cam_EXPORTED_TARGETS}"});
}
TEST(CmakeValues, lists_and_appends) {
  EXPECT_EQ(learned("set(A x y)\nlist(APPEND A z)").expand("${A}"), (Set{"x", "y", "z"}));
}
TEST(CmakeValues, loops) {
  EXPECT_EQ(learned("foreach(n a b)").expand("${n}_node"), (Set{"a_node", "b_node"}));
}
TEST(CmakeValues, loops_over_lists) {
  EXPECT_EQ(learned("set(A a b)\nset(B c)\nforeach(n IN LISTS A B ITEMS d)").expand("${n}"),
            (Set{"a", "b", "c", "d"}));
}
TEST(CmakeValues, unknown_stays) {
  EXPECT_EQ(learned("").expand("${catkin_LIBRARIES}"), Set{"${catkin_LIBRARIES}"});
}
TEST(CmakeValues, a_variable_that_holds_itself_ends) {
  EXPECT_FALSE(learned("set(A x)\nset(A ${A} y)\nset(A ${A} z)").expand("${A}").empty());
}
TEST(CmakeValues, flags_that_are_added_one_by_one_stay_few) {
  for (const std::string first : {"", "set(F x)\n"}) {
    std::string text = first;
    for (int i = 0; i < 40; ++i) text += "set(F \"${F} -flag" + std::to_string(i) + "\")\n";
    const Set values = learned(text).expand("${F}");
    EXPECT_LE(values.size(), 10'000u);
    EXPECT_EQ(values.count(" -flag0"), first.empty() ? 1u : 0u);
  }
}
TEST(CmakeValues, texts_that_double_stay_short) {
  std::string text = "set(F xxxxxxxx)\n";
  for (int i = 0; i < 60; ++i) text += "set(F \"${F}${F}\")\n";
  for (const std::string& value : learned(text).expand("${F}")) EXPECT_LE(value.size(), 70000u);
}

std::string xml(const std::string& text) {
  const auto document = scan_xml(text, "f");
  if (!document) return document.error().what;
  std::string out = document->root;
  for (const XmlElement& child : document->children) out += " " + child.name + "=" + child.text;
  return out;
}

TEST(ScanXml, children) {
  EXPECT_EQ(xml("<?xml version=\"1.0\"?><p a='1'><x> 1 </x><y/><x>2</x></p>"), "p x=1 y= x=2");
}
TEST(ScanXml, comments_are_no_elements) {
  EXPECT_EQ(xml("<p><!-- <x>1</x> --><y>2</y></p>"), "p y=2");
}
TEST(ScanXml, cdata_and_nested_elements) {
  EXPECT_EQ(xml("<p><d><![CDATA[<x>]]></d><e><x>1</x></e></p>"), "p d=<![CDATA[<x>]]> e=<x>1</x>");
}
TEST(ScanXml, a_bracket_in_an_attribute_ends_no_tag) {
  EXPECT_EQ(xml("<p><x condition=\"$ROS_DISTRO >= noetic\">1</x></p>"), "p x=1");
}
TEST(ScanXml, broken) {
  for (const char* text : {"", "text", "<p>", "<p><x></p", "</p>", "<p><!-- </p>"})
    EXPECT_EQ(xml(text), "is not well-formed XML") << text;
}
TEST(XmlAttribute, either_quotes) {
  EXPECT_EQ(xml_attribute("format=\"2\" x='y'", "format"), "2");
  EXPECT_EQ(xml_attribute("format = '3'", "format"), "3");
  EXPECT_EQ(xml_attribute("x=\"$A == 'b'\" y='2'", "x"), "$A == 'b'");
  EXPECT_EQ(xml_attribute("", "format"), "");
}

}  // namespace
}  // namespace tzc::rewriter
