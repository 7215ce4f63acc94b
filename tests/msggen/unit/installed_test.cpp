// SPDX-License-Identifier: BSD-3-Clause
// Packages of the machine: where they are found, and what of them.
#include <gmock/gmock.h>

#include "tool_case.h"

namespace tzc::msggen::test {
namespace {

using ::testing::HasSubstr;

/// An install space beside the machine's own.
class Installed : public Tool {
 protected:
  void SetUp() override { ::setenv("ROS_PACKAGE_PATH", (path("src") + ":" + path("share")).c_str(), 1); }
  void TearDown() override { ::unsetenv("ROS_PACKAGE_PATH"); }
  /// As generate_messages() installs it.
  void name_folders(const std::string& package, const std::string& list) {
    write("share/" + package + "/cmake/" + package + "-msg-paths.cmake",
          "# generated\n\n_prepend_path(\"${" + package + "_DIR}/..\" \"" + list + "\" " + package +
              "_MSG_INCLUDE_DIRS UNIQUE)\nset(" + package + "_MSG_DEPENDENCIES std_msgs)\n");
  }
  void link(const std::string& target, const std::string& name) {
    fs::create_directories(fs::path(path(name)).parent_path());
    fs::create_directory_symlink(path(target), path(name));
  }
  int explain_type(const std::string& type) { return explain({{}, type}, console_); }
  void install(const std::string& package, const std::string& file, const std::string& text) {
    write("share/" + package + "/package.xml", "<package><name>" + package + "</name></package>");
    write("share/" + package + "/" + file, text);
  }
  std::string header(const std::string& name) {
    GenerateOptions options;
    options.output = path("out");
    options.installed = true;
    EXPECT_EQ(generate(options, console_), exit_good) << err_.str();
    return fs::exists(path("out/tzc/" + name)) ? read("out/tzc/" + name) : "";
  }
};

TEST_F(Installed, one_odd_package_costs_the_others_nothing) {
  install("python_only", "msg/Odd.msg", "string class\n");
  install("good_msgs", "msg/A.msg", "uint8[] x\n");
  EXPECT_THAT(header("good_msgs/A.h"), HasSubstr("struct A {"));
  EXPECT_THAT(read("out/tzc/python_only/Odd.h"), HasSubstr("#error"));
  EXPECT_THAT(err_.str(), HasSubstr("warning:"));
}

TEST_F(Installed, a_message_and_a_service_of_one_name) {
  install("twice_msgs", "msg/Foo.msg", "uint8[] x\n");
  install("twice_msgs", "srv/Foo.srv", "uint8 a\n---\nuint8 b\n");
  install("twice_msgs", "msg/BarRequest.msg", "uint8[] x\n");
  install("twice_msgs", "srv/Bar.srv", "uint8 a # \xE9\n---\n");
  EXPECT_THAT(header("twice_msgs/Foo.h"), HasSubstr("struct Foo {"));
  EXPECT_THAT(read("out/tzc/twice_msgs/BarRequest.h"), HasSubstr("struct BarRequest {"));
  EXPECT_THAT(read("out/tzc/twice_msgs/Bar.h"), HasSubstr("#error"));
}

TEST_F(Installed, messages_in_folders_below_msg) {
  install("deep_msgs", "msg/inner/A.msg", "uint8[] x\n");
  install("deep_msgs", "msg/.hidden/A.msg", "uint16[] y\n");
  install("deep_msgs", "msg/B.msg", "A[] a\n");
  EXPECT_THAT(header("deep_msgs/B.h"), HasSubstr("tzc/deep_msgs/A.h"));
  EXPECT_THAT(read("out/tzc/deep_msgs/A.h"), HasSubstr("struct A {"));
  EXPECT_EQ(err_.str(), "");
}

TEST_F(Installed, a_checkout_that_hides_an_installed_package_stands_for_it) {
  install("some_msgs", "msg/A.msg", "uint8[] x\n");
  write("src/some_msgs/package.xml", "<package><name>some_msgs</name></package>");
  write("src/some_msgs/msg/A.msg", "uint16[] newer\n");
  write("src/own_msgs/msg/A.msg", "uint16[] x\n");
  EXPECT_THAT(header("some_msgs/A.h"), HasSubstr("newer"));
  EXPECT_FALSE(fs::exists(path("out/tzc/own_msgs"))) << "it generates its headers itself";
}

TEST_F(Installed, messages_where_the_package_says_that_they_are) {
  install("odd_msgs", "messages/A.msg", "uint8[] x\n");
  install("odd_msgs", "msg/B.msg", "A[] a\n");
  name_folders("odd_msgs", "msg;messages;messages");
  write("share/bare_msgs/defs/C.msg", "odd_msgs/A a\n");  // its package.xml is in another package
  name_folders("bare_msgs", "defs");
  EXPECT_THAT(header("odd_msgs/A.h"), HasSubstr("struct A {"));
  EXPECT_THAT(read("out/tzc/odd_msgs/B.h"), HasSubstr("struct B {"));
  EXPECT_THAT(read("out/tzc/bare_msgs/C.h"), HasSubstr("struct C {"));
  EXPECT_EQ(err_.str(), "");
}

TEST_F(Installed, a_devel_space_names_sources_which_belong_to_the_workspace) {
  write("src/own_msgs/messages/A.msg", "uint8 x\n");
  write("src/own_msgs/package.xml", "<package><name>own_msgs</name></package>");
  write("share/own_msgs/cmake/own_msgs-msg-paths.cmake",
        "set(own_msgs_MSG_INCLUDE_DIRS \"" + path("src/own_msgs/messages") + "\")\n");
  EXPECT_EQ(header("own_msgs/A.h"), "");
}

TEST_F(Installed, services_and_actions_in_folders_below) {
  install("deep_srvs", "srv/inner/Ask.srv", "uint8[] q\n---\n");
  install("deep_srvs", "action/inner/Go.action", "uint8[] g\n---\n---\n");
  EXPECT_THAT(header("deep_srvs/AskRequest.h"), HasSubstr("struct AskRequest {"));
  EXPECT_THAT(read("out/tzc/deep_srvs/GoGoal.h"), HasSubstr("struct GoGoal {"));
}

TEST_F(Installed, the_hint_names_the_folder_that_the_package_says) {
  install("odd_msgs", "messages/Peculiar.msg", "uint8[] x\n");
  name_folders("odd_msgs", "messages");
  EXPECT_EQ(generate_files({write("msg/U.msg", "odd_msgs/Peculiar a\n")}), exit_bad_input);
  EXPECT_THAT(err_.str(), HasSubstr("add -I odd_msgs:" + path("share/odd_msgs/messages")));
}

TEST_F(Installed, packages_that_are_symbolic_links) {
  write("repos/foo/package.xml", "<package><name>foo_msgs</name></package>");
  write("repos/foo/msg/Foo.msg", "uint8[] x\n");
  write("repos/parts/Part.msg", "uint8 x\n");
  link("repos/foo", "src/stack/foo_msgs");
  link("repos/parts", "repos/foo/msg/parts");
  EXPECT_EQ(explain_type("foo_msgs/Foo"), exit_good) << err_.str();
  EXPECT_EQ(explain_type("foo_msgs/Part"), exit_good) << err_.str();
  out_.str("");
  EXPECT_EQ(census({path("src")})["types"].size(), 2u) << err_.str();
}

TEST_F(Installed, a_link_to_a_folder_above_ends) {
  write("src/a_msgs/msg/A.msg", "uint8 x\n");
  write("elsewhere/b_msgs/msg/B.msg", "uint8 x\n");
  write("above_msgs/msg/C.msg", "uint8 x\n");
  link("elsewhere", "src/linked");
  link("src", "elsewhere/back");
  link("src", "src/itself");
  link("", "src/up");
  EXPECT_EQ(census({path("src")})["types"].size(), 2u) << out_.str();
}

TEST_F(Installed, a_package_keeps_its_name_beside_a_link_to_it) {
  write("src/z/real_msgs/msg/A.msg", "uint8 x\n");
  link("src/z/real_msgs", "src/alias_msgs");
  EXPECT_EQ(census({path("src")})["types"].begin().key(), "real_msgs/A");
}

}  // namespace
}  // namespace tzc::msggen::test
