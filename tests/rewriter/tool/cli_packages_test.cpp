// SPDX-License-Identifier: BSD-3-Clause
// How packages and their compile commands are found, and what is said of those that are not.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tool/cli_case.h"

namespace tzc::rewriter {
namespace {

using nlohmann::json;
using test::Cli;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

TEST_F(Cli, a_package_that_does_not_compile_is_an_error_and_nothing_is_written) {
  ws.plan()["error"] = "does not compile: unknown type name 'Foo'";
  const auto result = ws.rewrite({"--apply", "--report", ws.folder() / "r.json"});
  EXPECT_EQ(result.status, 2);
  EXPECT_THAT(result.errors,
              HasSubstr("src/node.cpp:3: does not compile: unknown type name 'Foo'\n  repair it\n"));
  EXPECT_FALSE(is_ported());
  EXPECT_THAT(ws.folder().read("r.json"), IsEmpty());
}

TEST_F(Cli, no_headers_of_tzc) {
  std::filesystem::remove_all(ws.folder() / "include/tzc/std_msgs");
  EXPECT_THAT(ws.rewrite({}).errors, HasSubstr("TZC's headers of the installed messages were not found"));
  std::filesystem::remove_all(ws.folder() / "include");
  const auto result = ws.rewrite({});
  EXPECT_EQ(result.status, 2);
  EXPECT_THAT(result.errors, HasSubstr("TZC's headers were not found"));
}

TEST_F(Cli, no_compile_commands) {
  std::filesystem::remove_all(ws.folder() / "ws/build");
  const auto result = ws.rewrite({});
  EXPECT_EQ(result.status, 2);
  EXPECT_THAT(result.errors, HasSubstr("-DCMAKE_EXPORT_COMPILE_COMMANDS=ON"));
}

TEST_F(Cli, configured_without_compile_commands) {
  std::filesystem::remove(ws.folder() / "ws/build/compile_commands.json");
  ws.folder().write("ws/build/CMakeCache.txt",
                    "demo_SOURCE_DIR:STATIC=" + (ws.folder() / "ws/src/demo") + "\n");
  ws.folder().write("ws/build/CMakeFiles/TargetDirectories.txt", "");
  for (const std::vector<std::string>& action : {std::vector<std::string>{}, {"--check"}}) {
    const auto result = ws.rewrite(action);
    EXPECT_EQ(result.status, 2);
    EXPECT_THAT(result.errors, AllOf(HasSubstr("was configured without compile commands"),
                                     HasSubstr("-DCMAKE_EXPORT_COMPILE_COMMANDS=ON")));
  }
}

TEST_F(Cli, compile_commands_of_something_else) {
  ws.folder().write("ws/build/compile_commands.json", "[]");
  EXPECT_EQ(ws.rewrite({"-p", ws.folder() / "ws/build"}).status, 2);
  ws.folder().write("ws/build/compile_commands.json", "{");
  const auto result = ws.rewrite({"-p", ws.folder() / "ws/build"});
  EXPECT_EQ(result.status, 2);
  EXPECT_THAT(result.errors, HasSubstr("is not a compilation database"));
}

TEST_F(Cli, usual_places_of_compile_commands) {
  std::filesystem::remove_all(ws.folder() / "ws/build");
  for (const char* place :
       {"ws/build/demo", "ws/build_isolated/demo", "build", "ws/src/demo/build", "ws/src/demo"}) {
    ws.database(place);
    EXPECT_EQ(ws.rewrite({}).status, 1) << place;
    std::filesystem::remove(ws.folder() / (std::string(place) + "/compile_commands.json"));
  }
}

TEST_F(Cli, a_package_that_the_workspace_holds_as_a_symbolic_link) {
  ws.rewrite({});
  std::filesystem::rename(ws.package(), ws.folder() / "elsewhere");
  std::filesystem::create_directory_symlink(ws.folder() / "elsewhere", ws.package());
  std::filesystem::create_directory_symlink(ws.folder() / "ws", ws.folder() / "ws/src/circle");
  EXPECT_EQ(ws.run({"--apply", ws.folder() / "ws/src"}).status, 0);
  EXPECT_TRUE(is_ported());
  EXPECT_TRUE(std::filesystem::is_symlink(ws.package()));
}

TEST_F(Cli, every_package_below_a_folder) {
  ws.rewrite({});
  EXPECT_EQ(ws.run({"--apply", ws.folder() / "ws/src"}).status, 0);
  EXPECT_TRUE(is_ported());
}

TEST_F(Cli, nothing_to_port_is_not_said_of_what_was_not_analysed) {
  ws.plan()["edits"] = json::array();
  ws.plan()["sites"] = json::array();
  const auto result = ws.rewrite({"--check", "--only", "topic=/nope"});
  EXPECT_EQ(result.status, 2);
  EXPECT_THAT(result.output,
              HasSubstr("nothing to port in what was analysed; the errors say what was not\n"));
}

TEST_F(Cli, a_package_without_cpp_needs_no_compile_commands) {
  std::filesystem::remove(ws.package() + "/src/node.cpp");
  std::filesystem::remove_all(ws.folder() / "ws/build");
  const auto result = ws.rewrite({});
  EXPECT_EQ(result.status, 0);
  EXPECT_THAT(result.errors, HasSubstr("nothing to port"));
}

/// Most often the package was not built, and all that publishes lacks a generated header.
TEST_F(Cli, nothing_to_port_is_not_all_that_is_said_where_files_were_not_read) {
  ws.plan()["edits"] = json::array();
  ws.plan()["sites"] = json::array();
  EXPECT_THAT(ws.rewrite({}).errors, HasSubstr("nothing to port\n"));
  ws.plan()["unread"] = {"src/node.cpp"};
  EXPECT_THAT(ws.rewrite({}).errors,
              HasSubstr("nothing to port in what was read; 1 file was not (TZC3003): build"));
  ws.plan()["unread"] = {"src/node.cpp", "src/other.cpp"};
  EXPECT_THAT(ws.rewrite({}).errors,
              HasSubstr("nothing to port in what was read; 2 files were not (TZC3003)"));
}

TEST_F(Cli, a_package_of_which_nothing_is_compiled_is_no_error_where_it_was_configured) {
  ws.folder().write("ws/build/compile_commands.json", "[]");
  EXPECT_EQ(ws.rewrite({}).status, 2);
  ws.folder().write("ws/build/CMakeCache.txt", "demo_SOURCE_DIR:STATIC=" + ws.package() + "\n");
  const auto result = ws.rewrite({});
  EXPECT_EQ(result.status, 0) << result.errors;
  EXPECT_THAT(result.errors, HasSubstr("TZC3001 src/node.cpp:1:1: no target of this configuration compiles"));
}

TEST_F(Cli, headers_of_a_package_without_sources_are_not_passed_over) {
  std::filesystem::remove(ws.package() + "/src/node.cpp");
  ws.folder().write("ws/src/demo/include/demo/out.hpp", "\npublisher.publish(message);\n");
  ws.folder().write("ws/src/demo/build2/CMakeCache.txt", "");
  ws.folder().write("ws/src/demo/build2/CMakeFiles/3.25/CMakeCXXCompilerId.cpp", "");
  const auto result = ws.rewrite({});
  EXPECT_EQ(result.status, 0) << result.errors;
  EXPECT_THAT(
      result.errors,
      HasSubstr("TZC3001 include/demo/out.hpp:1:1: no unit of the package that was read includes this "
                "header; possible sites in lines 2"));
  EXPECT_THAT(result.errors, Not(HasSubstr("CMakeCXXCompilerId")));
}

TEST_F(Cli, without_a_configured_build_nothing_is_written) {
  const auto result = ws.rewrite({"--verify=syntax", "--apply", "--report", ws.folder() / "r.json"});
  EXPECT_EQ(result.status, 1);
  EXPECT_FALSE(is_ported());
  EXPECT_THAT(result.output, HasSubstr("TZC4005"));
  EXPECT_THAT(result.output, HasSubstr("--verify=source"));
  EXPECT_THAT(result.output, Not(HasSubstr("ported; build")));
  EXPECT_EQ(json::parse(ws.folder().read("r.json"))["summary"]["files_changed"], 0);
}

TEST_F(Cli, a_port_that_was_not_configured_says_so) {
  const auto result = ws.rewrite({"--verify=source", "--apply"});
  EXPECT_EQ(result.status, 0);
  EXPECT_THAT(result.output, HasSubstr("TZC4006"));
  EXPECT_THAT(ws.rewrite({"--verify=source"}).errors, Not(HasSubstr("TZC4006"))) << "nothing changed";
}

TEST_F(Cli, a_package_that_fails_does_not_take_the_others_with_it) {
  ws.rewrite({});
  const std::string broken = ws.folder() / "ws/src/broken";
  std::filesystem::copy(ws.package(), broken, std::filesystem::copy_options::recursive);
  ws.folder().write("ws/src/broken/plan.json", R"({"error": "does not compile"})");
  json database = json::parse(ws.folder().read("ws/build/compile_commands.json"));
  database.push_back(database[0]);
  database[1]["file"] = broken + "/src/node.cpp";
  ws.folder().write("ws/build/compile_commands.json", database.dump());
  const auto result = ws.run({"--apply", ws.folder() / "ws/src"});
  EXPECT_EQ(result.status, 1) << "2 would say that nothing was written";
  EXPECT_THAT(result.errors, HasSubstr("does not compile"));
  EXPECT_TRUE(is_ported());
  EXPECT_EQ(ws.run({"--apply", broken}).status, 2);
}

TEST_F(Cli, exported_headers_are_kept_without_a_word) {
  EXPECT_THAT(ws.rewrite({}).errors, Not(HasSubstr("--exported-headers")));
  EXPECT_THAT(ws.rewrite({"--exported-headers=keep"}).errors, Not(HasSubstr("--exported-headers")));
}

TEST_F(Cli, who_uses_exported_headers_is_said_when_they_may_change) {
  ws.folder().write("ws/src/demo/include/demo/api.h", "");
  ws.folder().write("ws/src/demo/include/demo/own.h", "");
  ws.folder().write("ws/src/user/main.cpp", "#include <demo/api.h>\n");
  const std::string errors = ws.rewrite({"--exported-headers=change"}).errors;
  EXPECT_THAT(errors, HasSubstr("TZC1005 package.xml"));
  EXPECT_THAT(errors, HasSubstr("include/demo/api.h (by " + (ws.folder() / "ws/src/user/main.cpp") + ")"));
  EXPECT_THAT(errors, Not(HasSubstr("own.h")));
}

/// catkin build and catkin_make_isolated configure each package by itself, so that no build folder tells of the others.
TEST_F(Cli, users_of_exported_headers_are_searched_in_the_whole_workspace) {
  ws.folder().write("ws/src/demo/include/demo/api.h", "");
  ws.folder().write("ws/src/group/user/main.cpp", "#include <demo/api.h>\n");
  ws.folder().write("ws/.catkin_tools/profile", "");
  ws.folder().write("ws/build/CMakeCache.txt", "CMAKE_HOME_DIRECTORY:INTERNAL=" + ws.package() + "\n");
  const std::string errors = ws.rewrite({"--exported-headers=change"}).errors;
  EXPECT_THAT(errors,
              HasSubstr("include/demo/api.h (by " + (ws.folder() / "ws/src/group/user/main.cpp") + ")"));
}

TEST_F(Cli, exported_headers_are_kept_or_changed) {
  const auto mistake = ws.rewrite({"--exported-headers=both"});
  EXPECT_EQ(mistake.status, 2);
  EXPECT_THAT(mistake.errors, HasSubstr("both: is none of change, keep"));
}

/// `demo` and `user`, of which one includes a header of the other and both change.
class CliOfTwo : public Cli {
 protected:
  CliOfTwo() {
    ws.plan()["joined"] = {"user"};
    ws.plan()["includes"] = {{"include/demo/api.h", {"user/src/node.cpp", "demo/src/node.cpp"}}};
    ws.folder().write("ws/src/demo/include/demo/api.h", "");
    ws.rewrite({});
    std::filesystem::copy(ws.package(), user(), std::filesystem::copy_options::recursive);
    std::filesystem::remove_all(user() + "/include");
    ws.folder().write("ws/src/user/src/node.cpp", "#include <demo/api.h>\n" + ws.file("src/node.cpp"));
    ws.folder().write("ws/src/user/package.xml",
                      "<package format=\"2\">\n  <name>user</name>\n  <depend>demo</depend>\n</package>\n");
    plan_of_user_["joined"] = {"demo"};
    plan_of_user_["includes"] = {{"src/node.cpp", {"user/src/node.cpp"}}};
    plan_of_user_["edits"] = ws.plan()["edits"];
    plan_of_user_["sites"] = ws.plan()["sites"];
    json database = json::parse(ws.folder().read("ws/build/compile_commands.json"));
    database.push_back(database[0]);
    database[1]["file"] = user() + "/src/node.cpp";
    ws.folder().write("ws/build/compile_commands.json", database.dump());
  }
  std::string user() const { return ws.folder() / "ws/src/user"; }
  ProcessResult run_both(std::vector<std::string> words) {
    ws.folder().write("ws/src/user/plan.json", plan_of_user_.dump());
    words.insert(words.end(), {"--exported-headers=change", ws.folder() / "ws/src"});
    return ws.run(words);
  }
  bool is_user_ported() const {
    return ws.folder().read("ws/src/user/src/node.cpp").find("tzc::Publisher") != std::string::npos;
  }
  json plan_of_user_;
};

TEST_F(CliOfTwo, are_written_together_and_the_report_says_so) {
  const auto result = run_both({"--apply"});
  EXPECT_EQ(result.status, 0) << result.errors;
  EXPECT_TRUE(is_ported() && is_user_ported());
  EXPECT_THAT(result.output, HasSubstr("solved as one with it: user; nobody else includes one"));
}

TEST_F(CliOfTwo, what_no_unit_reaches_is_known_before_one_is_parsed) {
  plan_of_user_["echo"] = true;
  for (const std::string file : {"ws/src/user/test/api_test.cpp", "ws/src/user/src/api.cu"}) {
    ws.folder().write(file, "#include <demo/api.h>\n");
    EXPECT_THAT(run_both({}).errors, HasSubstr("in use: " + ws.package() + "/include/demo/api.h\n")) << file;
    std::filesystem::remove(ws.folder() / file);
  }
  EXPECT_THAT(run_both({}).errors, Not(HasSubstr("in use: " + ws.package() + "/include/demo/api.h\n")));
}

TEST_F(CliOfTwo, an_undo_patch_takes_both_back) {
  run_both({"--apply", "--undo", ws.folder() / "undo.patch"});
  ASSERT_TRUE(is_ported() && is_user_ported());
  ASSERT_EQ(ws.shell("cd src && patch -p1 < ../../undo.patch"), 0);
  EXPECT_FALSE(is_ported() || is_user_ported());
}

TEST_F(CliOfTwo, a_use_that_no_compiler_sees_keeps_the_header) {
  plan_of_user_["includes"] = json::object();
  EXPECT_THAT(run_both({}).errors, HasSubstr("stay: include/demo/api.h (by " + user() + "/src/node.cpp)"));
}

TEST_F(CliOfTwo, when_one_cannot_be_analysed_the_other_is_ported_alone) {
  plan_of_user_["error"] = "does not compile";
  ws.plan()["joined"] = json::array();
  const auto result = run_both({"--apply"});
  EXPECT_EQ(result.status, 1);
  EXPECT_TRUE(is_ported());
  EXPECT_THAT(result.errors, HasSubstr("they could not be solved as one: "));
  EXPECT_THAT(result.output, HasSubstr("include/demo/api.h (by "));
}

TEST_F(CliOfTwo, the_result_of_each_is_said_as_it_is_known) {
  const std::string errors = run_both({"--apply"}).errors;
  EXPECT_THAT(errors, HasSubstr("tzc-rewrite: demo: publish: 1 zero_copy"));
  EXPECT_THAT(errors, HasSubstr("tzc-rewrite: user: "));
  EXPECT_THAT(run_both({"--check", "--quiet"}).errors, Not(HasSubstr("demo: ")));
}

TEST_F(CliOfTwo, without_the_option_each_is_alone) {
  EXPECT_THAT(ws.run({ws.folder() / "ws/src"}).errors, Not(HasSubstr("solved as one")));
}

}  // namespace
}  // namespace tzc::rewriter
