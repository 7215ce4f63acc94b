// SPDX-License-Identifier: BSD-3-Clause
// The program as its user meets it: what it prints where, what it writes, how it ends.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "edits/files.h"
#include "model/codes.h"
#include "tool/workspace.h"

namespace tzc::rewriter {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;

class Cli : public ::testing::Test {
 protected:
  bool is_ported() const { return ws.file("src/node.cpp").find("tzc::Publisher") != std::string::npos; }
  json refusal() const {
    return {{"id", "publish:src/node.cpp:main:1"}, {"line", 3}, {"level", "plain"}, {"code", "TZC1001"}};
  }
  test::Workspace ws;
};

TEST_F(Cli, dry_run_writes_nothing_and_shows_a_diff) {
  const auto result = ws.rewrite({});
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.output, HasSubstr("-ros::Publisher pub;\n+tzc::Publisher pub;\n"));
  EXPECT_THAT(result.output, HasSubstr("+find_package(catkin REQUIRED COMPONENTS roscpp tzc)"));
  EXPECT_THAT(result.errors, HasSubstr("zero_copy"));
  EXPECT_FALSE(is_ported());
}

TEST_F(Cli, git_apply_takes_the_diff_from_anywhere_in_the_repository) {
  ASSERT_EQ(ws.shell("git init -q ."), 0);
  ws.rewrite({"-q"});
  for (const char* folder : {".", "src", "src/demo/src"}) {
    ws.shell("git checkout -q . || true");
    const std::string command = std::string("cd ") + folder +
                                " && " FAKE_REWRITE " -q --verify=source --tzc-include " +
                                ws.folder().path() + "/include " + ws.package() +
                                " > /tmp/p.$$; git apply /tmp/p.$$; s=$?; rm /tmp/p.$$; exit $s";
    EXPECT_EQ(ws.shell(command), 0) << folder;
    EXPECT_TRUE(is_ported() || std::string(folder) == "src/demo/src") << folder;
    ws.folder().write("ws/src/demo/src/node.cpp",
                      "#include <ros/ros.h>\nros::Publisher pub;\nint main() {}\n");
  }
}

TEST_F(Cli, patch_takes_the_diff_without_git) {
  EXPECT_EQ(ws.shell("GIT_CEILING_DIRECTORIES=/ " FAKE_REWRITE
                     " -q --verify=source --tzc-include ../include src/demo | patch -p1"),
            256 * 0);
}

TEST_F(Cli, apply_ports_and_a_second_run_changes_nothing) {
  EXPECT_EQ(ws.rewrite({"--apply"}).status, 0);
  EXPECT_TRUE(is_ported());
  const std::string cmake = ws.file("CMakeLists.txt"), xml = ws.file("package.xml");
  EXPECT_THAT(xml, HasSubstr("<depend>tzc</depend>"));
  EXPECT_EQ(ws.rewrite({"--apply"}).status, 0);
  EXPECT_EQ(ws.file("CMakeLists.txt"), cmake);
  EXPECT_EQ(ws.file("package.xml"), xml);
  const auto dry = ws.rewrite({});
  EXPECT_EQ(dry.status, 0);
  EXPECT_THAT(dry.output, IsEmpty());
}

TEST_F(Cli, out_dir_gets_a_whole_copy) {
  EXPECT_EQ(ws.rewrite({"--out-dir", ws.folder() / "out"}).status, 0);
  EXPECT_FALSE(is_ported());
  EXPECT_THAT(ws.folder().read("out/demo/src/node.cpp"), HasSubstr("tzc::Publisher"));
  EXPECT_THAT(ws.folder().read("out/demo/plan.json"), Not(IsEmpty()));
}

TEST_F(Cli, out_dir_inside_the_package_is_refused) {
  EXPECT_EQ(ws.rewrite({"--out-dir", ws.package() + "/out"}).status, 2);
}

TEST_F(Cli, a_package_that_does_not_compile_is_an_error_and_nothing_is_written) {
  ws.plan()["error"] = "does not compile: unknown type name 'Foo'";
  const auto result = ws.rewrite({"--apply", "--report", ws.folder() / "r.json"});
  EXPECT_EQ(result.status, 2);
  EXPECT_THAT(result.errors,
              HasSubstr("src/node.cpp:3: does not compile: unknown type name 'Foo'\n  repair it\n"));
  EXPECT_FALSE(is_ported());
  EXPECT_THAT(ws.folder().read("r.json"), IsEmpty());
}

TEST_F(Cli, a_file_changed_during_the_analysis_stops_the_run) {
  for (const char* file : {"src/node.cpp", "src/other.h"}) {
    ws.plan()["touch"] = file;
    const auto result = ws.rewrite({"--apply"});
    EXPECT_EQ(result.status, 2);
    EXPECT_THAT(result.errors,
                HasSubstr(std::string(file) + ": changed while the package was being analysed"));
    EXPECT_FALSE(is_ported());
  }
}

TEST_F(Cli, uncommitted_changes_are_not_written_over) {
  ws.plan()["sites"] = json::array();
  ws.rewrite({});
  ASSERT_EQ(ws.shell("git init -q . && git add -A && git -c user.name=a -c user.email=a@b commit -qm x"), 0);
  ws.folder().write("ws/src/demo/src/node.cpp", "// mine\n#include <ros/ros.h>\nros::Publisher pub;\n");
  const auto refused = ws.rewrite({"--apply"});
  EXPECT_EQ(refused.status, 2);
  EXPECT_THAT(refused.errors, HasSubstr("src/demo/src/node.cpp: has changes that git does not have"));
  EXPECT_THAT(refused.errors, HasSubstr("--force"));
  EXPECT_FALSE(is_ported());
  EXPECT_EQ(ws.rewrite({"--apply", "--force"}).status, 0);
  EXPECT_THAT(ws.file("src/node.cpp"), StartsWith("// mine\n#include <ros/ros.h>\ntzc::Publisher"));
}

TEST_F(Cli, committed_files_are) {
  ws.rewrite({});
  ASSERT_EQ(ws.shell("git init -q . && git add -A && git -c user.name=a -c user.email=a@b commit -qm x"), 0);
  EXPECT_EQ(ws.rewrite({"--apply"}).status, 0);
  EXPECT_TRUE(is_ported());
}

TEST_F(Cli, check_is_silent_about_the_diff) {
  const auto result = ws.rewrite({"--check"});
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.output, Not(HasSubstr("@@")));
  EXPECT_FALSE(is_ported());
  ws.rewrite({"--apply"});
  EXPECT_EQ(ws.rewrite({"--check"}).status, 0);
}

/// The red CI of a package that could be ported: what fails the check is in the file for code scanning.
TEST_F(Cli, check_names_each_site_that_could_be_ported_in_sarif) {
  const std::string sarif = ws.folder() / "tzc.sarif";
  const auto results = [&] { return json::parse(ws.folder().read("tzc.sarif"))["runs"][0]["results"]; };
  EXPECT_EQ(ws.rewrite({"--check", "--report", sarif}).status, 1);
  json pending;
  for (const json& result : results())
    if (result["ruleId"] == codes::TZC5001) pending = result;
  ASSERT_FALSE(pending.is_null()) << results();
  EXPECT_EQ(pending["locations"][0]["physicalLocation"]["region"]["startLine"], 2);
  EXPECT_EQ(pending["locations"][0]["physicalLocation"]["artifactLocation"]["uri"], "src/node.cpp");
  EXPECT_EQ(pending["fixes"][0]["artifactChanges"].size(), 3u);
  ws.rewrite({"--apply"});
  ws.rewrite({"--check", "--report", sarif});
  EXPECT_THAT(results(), IsEmpty());
}

TEST_F(Cli, check_names_a_build_file_when_only_that_is_left) {
  ws.plan()["sites"][0]["pending"] = false;
  const std::string sarif = ws.folder() / "tzc.sarif";
  EXPECT_EQ(ws.rewrite({"--check", "--report", sarif}).status, 1);
  EXPECT_THAT(ws.folder().read("tzc.sarif"), HasSubstr("TZC5001"));
}

TEST_F(Cli, sarif_takes_paths_from_the_top_of_the_repository) {
  ASSERT_EQ(ws.shell("git init -q ."), 0);
  ws.rewrite({"--check", "--report", ws.folder() / "tzc.sarif"});
  const json run = json::parse(ws.folder().read("tzc.sarif"))["runs"][0];
  EXPECT_THAT(run["originalUriBaseIds"]["SRCROOT"]["uri"], StartsWith("file://"));
  for (const json& result : run["results"])
    for (const json& location : result["locations"])
      EXPECT_THAT(location["physicalLocation"]["artifactLocation"]["uri"], StartsWith("src/demo/"));
}

TEST_F(Cli, a_refusal_is_work_left_until_it_is_suppressed) {
  ws.plan()["edits"] = json::array();
  ws.plan()["sites"] = {refusal()};
  EXPECT_EQ(ws.rewrite({"--check"}).status, 1);
  ws.folder().write("ws/src/demo/src/node.cpp",
                    "\n\nint x;  // tzc-ignore[TZC1001]: the driver wants it so\n");
  const auto result = ws.rewrite({"--check"});
  EXPECT_EQ(result.status, 0);
  EXPECT_THAT(result.output, HasSubstr("(suppressed: the driver wants it so)"));
}

TEST_F(Cli, a_baseline_accepts_what_it_knows_and_nothing_else) {
  ws.plan()["edits"] = json::array();
  ws.plan()["sites"] = {refusal()};
  const std::string baseline = ws.folder() / "baseline.json";
  ws.rewrite({"--report", baseline});
  EXPECT_EQ(ws.rewrite({"--check", "--baseline", baseline}).status, 0);
  json other = refusal();
  other["id"] = "publish:src/node.cpp:main:2";
  other["line"] = 4;
  ws.plan()["sites"].push_back(other);
  EXPECT_EQ(ws.rewrite({"--check", "--baseline", baseline}).status, 1);
  EXPECT_EQ(ws.rewrite({"--check", "--baseline", ws.folder() / "none.json"}).status, 2);
}

TEST_F(Cli, json_report) {
  ws.rewrite({"--report", ws.folder() / "r.json"});
  const json report = json::parse(ws.folder().read("r.json"));
  EXPECT_EQ(report["version"], 1);
  EXPECT_EQ(report["package"], "demo");
  EXPECT_EQ(report["sites"][0]["file"], "src/node.cpp");
  EXPECT_EQ(report["sites"][0]["topic"], "image");
  EXPECT_EQ(report["summary"]["files_changed"], 3);
}

TEST_F(Cli, options_reach_the_engine) {
  ws.plan()["echo"] = true;
  EXPECT_THAT(
      ws.rewrite({"--level=one_copy", "--on-exhausted=drop", "--mem-size=64M", "--dual", "-j", "3"}).errors,
      HasSubstr("level=one_copy on_exhausted=1 mem_size=67108864 dual=true jobs=3"));
}

TEST_F(Cli, only_and_except_select_sites) {
  json other = refusal();
  other["topic"] = "/cloud";
  ws.plan()["sites"].push_back(other);
  const std::string report = ws.folder() / "r.json";
  const auto sites = [&](const std::string& option) {
    ws.rewrite({option, "--report", report});
    return json::parse(ws.folder().read("r.json"))["sites"].size();
  };
  EXPECT_EQ(sites("--only=topic=cloud"), 1u);
  EXPECT_EQ(sites("--only=topic=im*,topic=cloud"), 2u);
  EXPECT_EQ(sites("--only=type=std_msgs/*"), 0u);
  EXPECT_EQ(sites("--except=file=src/*"), 0u);
  EXPECT_EQ(sites("--except=topic=image"), 1u);
}

TEST_F(Cli, a_site_twice_in_the_report_is_a_defect_that_stops_everything) {
  ws.plan()["sites"].push_back(ws.plan()["sites"][0]);
  const auto result = ws.rewrite({"--apply"});
  EXPECT_EQ(result.status, 2);
  EXPECT_THAT(result.errors, HasSubstr("defect of tzc-rewrite"));
  EXPECT_FALSE(is_ported());
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

TEST_F(Cli, a_package_without_cpp_needs_no_compile_commands) {
  std::filesystem::remove(ws.package() + "/src/node.cpp");
  std::filesystem::remove_all(ws.folder() / "ws/build");
  const auto result = ws.rewrite({});
  EXPECT_EQ(result.status, 0);
  EXPECT_THAT(result.errors, HasSubstr("nothing to port"));
}

/// Where the kill hits is chance here; swap_test.cpp has it at each step.
TEST_F(Cli, killed_at_any_time_the_package_is_old_or_new_after_the_next_start) {
  ws.rewrite({});
  const char* names[] = {"CMakeLists.txt", "package.xml", "src/node.cpp"};
  std::map<std::string, std::string> before;
  for (const char* name : names) before[name] = ws.file(name);
  const std::string command = " " FAKE_REWRITE " --apply --verify=source --tzc-include ../include src/demo";
  for (int milliseconds = 10; milliseconds < 34; ++milliseconds) {
    for (const char* name : names) ws.folder().write(std::string("ws/src/demo/") + name, before[name]);
    ws.shell("timeout -s KILL 0.0" + std::to_string(milliseconds) + command);
    const auto next = ws.rewrite({});
    ASSERT_NE(next.status, 2) << next.errors;
    EXPECT_FALSE(std::filesystem::exists(ws.package() + "/.tzc-rewrite"));
    int changed = 0;
    for (const char* name : names) changed += ws.file(name) != before[name];
    EXPECT_TRUE(changed == 0 || changed == 3) << changed << " of 3 files changed";
  }
}

TEST_F(Cli, an_interrupted_run_is_finished_by_the_next_start) {
  ws.folder().write("ws/src/demo/.tzc-rewrite/0", "half");
  EXPECT_EQ(ws.rewrite({}).status, 1);
  EXPECT_FALSE(std::filesystem::exists(ws.package() + "/.tzc-rewrite"));
}

struct Mistake {
  std::vector<std::string> words;
  const char* says;
};
TEST_F(Cli, mistakes_on_the_command_line) {
  const Mistake mistakes[] = {{{"--bogus"}, "--bogus"},
                              {{"--report", "r.txt"}, "a report ends in .json, .sarif or .html"},
                              {{"--only", "node=x"}, "topic=GLOB"},
                              {{"--mem-size", "lots"}, "a size is a number of bytes"},
                              {{"--level", "best"}, "--level"},
                              {{"--apply", "--check"}, ""},
                              {{"/nonexistent"}, "is no folder"},
                              {{"--bag", "/nonexistent.bag"}, "cannot be read"}};
  for (const Mistake& mistake : mistakes) {
    const auto result = ws.rewrite(mistake.words);
    EXPECT_EQ(result.status, 2) << mistake.words[0];
    EXPECT_THAT(result.errors, HasSubstr(mistake.says));
    EXPECT_THAT(result.output, IsEmpty());
  }
  const auto none = ws.run({});
  EXPECT_EQ(none.status, 2);
  EXPECT_THAT(none.errors, HasSubstr("no package is named"));
}

TEST_F(Cli, help_and_version) {
  const auto help = ws.run({"--help"});
  EXPECT_EQ(help.status, 0);
  for (const char* text : {"--apply", "--out-dir", "--check", "--baseline", "--only", "--except",
                           "--on-exhausted", "--bag", "Examples:", "Exit status:", "tzc-ignore"})
    EXPECT_THAT(help.output, HasSubstr(text));
  EXPECT_THAT(ws.run({"--version"}).output, StartsWith("tzc-rewrite "));
}

TEST_F(Cli, explain) {
  for (const char* name : {"TZC1004", "tzc1004", "forwarded-message"}) {
    const auto page = ws.run({"--explain", name});
    EXPECT_EQ(page.status, 0);
    EXPECT_THAT(page.output, HasSubstr("TZC1004"));
  }
  EXPECT_EQ(ws.run({"--explain", "TZC9999"}).status, 2);
  EXPECT_THAT(ws.run({"--list-codes"}).output, HasSubstr("TZC4001"));
}

TEST_F(Cli, quiet) {
  const auto result = ws.rewrite({"-q"});
  EXPECT_THAT(result.errors, IsEmpty());
  EXPECT_THAT(result.output, HasSubstr("@@"));
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

TEST_F(Cli, a_filter_that_matches_nothing_is_warned_about) {
  EXPECT_THAT(ws.rewrite({"--only=topic=imgae"}).errors,
              HasSubstr("warning: --only topic=imgae matches no site"));
  EXPECT_THAT(ws.rewrite({"--only=topic=image"}).errors, Not(HasSubstr("matches no site")));
}

TEST_F(Cli, a_report_that_cannot_be_written_is_known_before_the_analysis) {
  const auto result = ws.rewrite({"--apply", "--report", ws.folder() / "missing/r.json"});
  EXPECT_EQ(result.status, 2);
  EXPECT_THAT(result.errors, HasSubstr("missing/r.json"));
  EXPECT_FALSE(is_ported());
}

TEST_F(Cli, a_report_is_replaced_when_it_is_whole) {
  const std::string report = ws.folder().write("r.json", "old");
  ws.plan()["error"] = "does not compile";
  EXPECT_EQ(ws.rewrite({"--report", report}).status, 2);
  EXPECT_EQ(ws.folder().read("r.json"), "old");
  ws.plan().erase("error");
  ws.rewrite({"--report", report});
  EXPECT_EQ(json::parse(ws.folder().read("r.json"))["package"], "demo");
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(ws.folder().path()))
    files += entry.is_regular_file();
  EXPECT_EQ(files, 1) << "something is left beside the report";
}

/// A second package beside "demo", whose analysis fails.
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

TEST_F(Cli, out_dir_keeps_what_is_there_and_leaves_nothing_behind) {
  ws.folder().write("out/demo/mine", "1");
  ws.folder().write("out/demo/src/node.cpp", "old");
  EXPECT_EQ(ws.rewrite({"--out-dir", ws.folder() / "out"}).status, 0);
  EXPECT_THAT(ws.folder().read("out/demo/src/node.cpp"), HasSubstr("tzc::Publisher"));
  EXPECT_EQ(ws.folder().read("out/demo/mine"), "1");
  for (const auto& entry : std::filesystem::directory_iterator(ws.folder() / "out"))
    EXPECT_EQ(entry.path().filename(), "demo");
  EXPECT_EQ(ws.rewrite({"--out-dir", ws.folder() / "include/tzc/ros.h/out"}).status, 2);
}

/// The command that undoes a port, from the last line of the run.
std::string undo_command(const std::string& output) {
  const std::size_t begin = output.find("  patch -p1");
  return begin == std::string::npos ? "" : output.substr(begin, output.find('\n', begin) - begin);
}

TEST_F(Cli, apply_ends_with_the_command_that_takes_it_back) {
  ws.folder().write("ws/src/demo/src/node.cpp",
                    "#include <ros/ros.h>\r\nros::Publisher pub;\r\nint main() {}");
  const char* names[] = {"CMakeLists.txt", "package.xml", "src/node.cpp"};
  std::map<std::string, std::string> before;
  for (const char* name : names) before[name] = ws.file(name);
  const auto applied = ws.rewrite({"--apply"});
  ASSERT_TRUE(is_ported());
  EXPECT_EQ(ws.shell("cd / && " + undo_command(applied.output)), 0) << applied.output;
  for (const char* name : names) EXPECT_EQ(ws.file(name), before[name]) << name;
  EXPECT_THAT(undo_command(applied.output), HasSubstr("state/tzc/undo/"));
  ws.rewrite({"--apply"});
  EXPECT_EQ(undo_command(ws.rewrite({"--apply"}).output), "") << "the second run wrote nothing";
}

TEST_F(Cli, the_undo_patch_goes_where_the_user_wants_it) {
  const std::string file = ws.folder() / "it's mine.patch";
  const auto applied = ws.rewrite({"--apply", "--undo", file});
  ASSERT_TRUE(is_ported());
  EXPECT_EQ(ws.shell(undo_command(applied.output)), 0) << applied.output;
  EXPECT_FALSE(is_ported());
  const auto refused = ws.rewrite({"--apply", "--undo", ws.folder() / "missing/u.patch"});
  EXPECT_EQ(refused.status, 2);
  EXPECT_FALSE(is_ported());
}

TEST_F(Cli, one_patch_takes_several_packages_back) {
  ws.rewrite({});
  const std::string other = ws.folder() / "ws/src/other";
  std::filesystem::copy(ws.package(), other, std::filesystem::copy_options::recursive);
  json database = json::parse(ws.folder().read("ws/build/compile_commands.json"));
  database.push_back(database[0]);
  database[1]["file"] = other + "/src/node.cpp";
  ws.folder().write("ws/build/compile_commands.json", database.dump());
  const auto applied = ws.run({"--apply", ws.folder() / "ws/src"});
  EXPECT_TRUE(is_ported());
  EXPECT_THAT(ws.folder().read("ws/src/other/src/node.cpp"), HasSubstr("tzc::Publisher"));
  EXPECT_EQ(ws.shell(undo_command(applied.output)), 0) << applied.output;
  EXPECT_FALSE(is_ported());
  EXPECT_THAT(ws.folder().read("ws/src/other/src/node.cpp"), Not(HasSubstr("tzc::")));
}

TEST_F(Cli, no_place_for_the_undo_patch_is_a_warning) {
  ws.folder().write("state", "a file, not a folder");
  const auto applied = ws.rewrite({"--apply"});
  EXPECT_EQ(applied.status, 0) << applied.errors;
  EXPECT_TRUE(is_ported());
  EXPECT_THAT(applied.errors, HasSubstr("warning: no undo patch could be saved"));
}

TEST_F(Cli, a_run_that_finishes_another_one_does_not_end_as_if_nothing_was_written) {
  ws.rewrite({});
  const std::string old_text = ws.file("src/node.cpp"), new_text = "// new\n" + old_text;
  ws.folder().write("ws/src/demo/.tzc-rewrite/0", new_text);
  ws.folder().write("ws/src/demo/.tzc-rewrite/journal.json", json{{"version", 1},
                                                                  {"files",
                                                                   {{{"staged", "0"},
                                                                     {"target", "src/node.cpp"},
                                                                     {"old", content_hash(old_text)},
                                                                     {"new", content_hash(new_text)}}}}}
                                                                 .dump());
  ws.plan()["error"] = "does not compile";
  EXPECT_EQ(ws.rewrite({"--check"}).status, 1) << "2 would say that nothing was written";
  EXPECT_EQ(ws.file("src/node.cpp"), new_text);
}

TEST_F(Cli, what_is_not_the_tools_own_stays_in_its_folder) {
  ws.folder().write("ws/src/demo/.tzc-rewrite/0", "half");
  ws.folder().write("ws/src/demo/.tzc-rewrite/notes.txt", "mine");
  ws.rewrite({"--apply"});
  EXPECT_EQ(ws.file(".tzc-rewrite/notes.txt"), "mine");
  EXPECT_FALSE(std::filesystem::exists(ws.package() + "/.tzc-rewrite/0"));
  EXPECT_TRUE(is_ported());
}

TEST_F(Cli, an_out_dir_that_gets_nothing_is_not_made) {
  ws.plan()["error"] = "does not compile";
  EXPECT_EQ(ws.rewrite({"--out-dir", ws.folder() / "out"}).status, 2);
  EXPECT_FALSE(std::filesystem::exists(ws.folder() / "out"));
}

TEST_F(Cli, progress_in_a_log_is_a_line_for_each_stage) {
  ws.plan()["progress"] = 3;
  EXPECT_THAT(ws.rewrite({}).errors,
              HasSubstr("tzc-rewrite: parsing 1/3 node.cpp\ntzc-rewrite: parsing 3/3 node.cpp\n"));
  EXPECT_THAT(ws.rewrite({"-q"}).errors, IsEmpty());
}

}  // namespace
}  // namespace tzc::rewriter
