// SPDX-License-Identifier: BSD-3-Clause
// What is written, where, and what an interrupted run leaves.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "edits/files.h"
#include "tool/cli_case.h"

namespace tzc::rewriter {
namespace {

using nlohmann::json;
using test::Cli;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;

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

/// Status 2 would say that nothing was written.
TEST_F(Cli, what_is_written_counts_though_the_report_finds_a_full_disk) {
  ws.rewrite({"-q"});  // leaves the plan
  const std::string command = FAKE_REWRITE
      " --verify=source --tzc-include ../include --report report.json --apply src/demo >/dev/full 2>errors; "
      "echo $? >status";
  ASSERT_EQ(ws.shell(command), 0);
  EXPECT_EQ(ws.folder().read("ws/status"), "1\n");
  EXPECT_THAT(ws.folder().read("ws/errors"), HasSubstr("standard output: cannot be written: No space left"));
  EXPECT_THAT(ws.folder().read("ws/report.json"), HasSubstr("zero_copy"));
  EXPECT_TRUE(is_ported());
}

/// It prints into a pipe that nobody reads any more.
class CliPipe : public Cli {
 protected:
  /// `streams`: of tzc-rewrite, whose exit status then lies in ws/status.
  void apply(const std::string& streams) {
    ws.rewrite({"-q"});  // leaves the plan
    const std::string rewrite =
        FAKE_REWRITE " --verify=source --tzc-include ../include --report report.json --apply src/demo ";
    ASSERT_EQ(ws.shell("{ while [ ! -e closed ]; do sleep 0.01; done; " + rewrite + streams +
                       "; echo $? >status; } | { exec <&-; touch closed; }"),
              0);
    EXPECT_THAT(ws.folder().read("ws/report.json"), HasSubstr("zero_copy"));
    EXPECT_TRUE(is_ported());
  }
};

TEST_F(CliPipe, a_reader_that_goes_takes_no_report_along) {
  apply("2>errors");
  EXPECT_EQ(ws.folder().read("ws/status"), "1\n");
  EXPECT_THAT(ws.folder().read("ws/errors"), HasSubstr("standard output: cannot be written: Broken pipe"));
}

TEST_F(CliPipe, nobody_need_read_what_is_said_meanwhile) {
  ws.plan()["progress"] = 3;
  apply("2>&1 >output");
  EXPECT_EQ(ws.folder().read("ws/status"), "0\n");
  EXPECT_THAT(ws.folder().read("ws/output"), HasSubstr("zero_copy"));
}

TEST_F(Cli, a_copy_that_a_killed_run_left_is_in_nobodys_way) {
  ws.rewrite({"-q"});  // leaves the plan
  const std::string kill =
      "sh -c 'mkdir -p out/.tzc-rewrite-$$/demo; touch out/.tzc-rewrite-$$/demo/package.xml; "
      "exec " FAKE_REWRITE " --verify=source --tzc-include ../include --out-dir out src/demo'";
  EXPECT_EQ(ws.shell(kill), 0);
  EXPECT_THAT(ws.folder().read("ws/out/demo/src/node.cpp"), HasSubstr("tzc::Publisher"));
}

TEST_F(Cli, patch_takes_the_diff_without_git) {
  EXPECT_EQ(ws.shell("GIT_CEILING_DIRECTORIES=/ " FAKE_REWRITE
                     " -q --verify=source --tzc-include ../include src/demo | patch -p1"),
            256 * 0);
}

TEST_F(Cli, build_files_that_are_links_stay_links) {
  for (const std::string name : {"CMakeLists.txt", "package.xml"}) {
    std::filesystem::rename(ws.package() + "/" + name, ws.package() + "/ros1_" + name);
    std::filesystem::create_symlink("ros1_" + name, ws.package() + "/" + name);
  }
  EXPECT_EQ(ws.rewrite({"--out-dir", ws.folder() / "out"}).status, 0);
  EXPECT_THAT(ws.file("ros1_package.xml"), Not(HasSubstr("tzc")));
  EXPECT_EQ(ws.rewrite({"--apply"}).status, 0);
  for (const std::string folder : {"ws/src/demo/", "out/demo/"})
    for (const std::string name : {"CMakeLists.txt", "package.xml"}) {
      EXPECT_TRUE(std::filesystem::is_symlink(ws.folder() / (folder + name))) << folder << name;
      EXPECT_THAT(ws.folder().read(folder + "ros1_" + name), HasSubstr("tzc")) << folder << name;
    }
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

/// With the cache of another folder CMake would refuse the copy.
TEST_F(Cli, out_dir_gets_no_build_that_lies_among_the_sources) {
  ws.database("ws/src/demo");
  ws.folder().write("ws/src/demo/CMakeCache.txt", "x");
  ws.folder().write("ws/src/demo/CMakeFiles/x.cpp", "x");
  EXPECT_EQ(ws.rewrite({"--out-dir", ws.folder() / "out"}).status, 0);
  EXPECT_THAT(ws.folder().read("out/demo/src/node.cpp"), HasSubstr("tzc::Publisher"));
  EXPECT_THAT(ws.folder().read("out/demo/plan.json"), Not(IsEmpty()));
  EXPECT_FALSE(std::filesystem::exists(ws.folder() / "out/demo/CMakeCache.txt"));
  EXPECT_FALSE(std::filesystem::exists(ws.folder() / "out/demo/CMakeFiles"));
}

TEST_F(Cli, out_dir_keeps_the_folders_of_the_repository) {
  ws.rewrite({});
  const std::string repository = ws.folder() / "ws/src/repository";
  std::filesystem::create_directories(repository + "/drivers");
  std::filesystem::rename(ws.package(), repository + "/drivers/demo");
  ws.folder().write("ws/build/compile_commands.json",
                    nlohmann::json::array({{{"directory", ws.folder().path()},
                                            {"file", repository + "/drivers/demo/src/node.cpp"},
                                            {"command", "c++ -c x"}}})
                        .dump());
  EXPECT_EQ(ws.shell(FAKE_REWRITE
                     " --verify=source --tzc-include ../include -p build --out-dir ../out src/repository"),
            0);
  EXPECT_THAT(ws.folder().read("out/drivers/demo/src/node.cpp"), HasSubstr("tzc::Publisher"));
}

TEST_F(Cli, out_dir_inside_the_package_is_refused) {
  EXPECT_EQ(ws.rewrite({"--out-dir", ws.package() + "/out"}).status, 2);
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

/// Code may be included from a file of any name, and so may commands of CMake.
TEST_F(Cli, what_is_edited_may_have_any_name) {
  ws.folder().write("ws/src/demo/src/node.impl", "ros::Publisher other;\n");
  ws.folder().write("ws/src/demo/CMakeLists_ros1.txt", ws.file("CMakeLists.txt"));
  ws.folder().write("ws/src/demo/CMakeLists.txt", "include(CMakeLists_ros1.txt)\n");
  ws.folder().write("ws/src/demo/run.log", "");
  ws.plan()["edits"].push_back(
      {{"file", "src/node.impl"}, {"find", "ros::Publisher"}, {"replace", "tzc::Publisher"}});
  ws.plan()["includes"]["src/node.impl"] = json::array({"demo/src/node.cpp"});
  ws.plan()["touch"] = "src/node.impl";
  EXPECT_THAT(ws.rewrite({"--apply"}).errors,
              HasSubstr("src/node.impl: changed while the package was being analysed"));
  ws.plan()["touch"] = "run.log";
  const auto result = ws.rewrite({"--apply"});
  EXPECT_EQ(result.status, 0) << result.errors;
  EXPECT_THAT(ws.file("src/node.impl"), HasSubstr("tzc::Publisher other"));
  EXPECT_THAT(ws.file("CMakeLists_ros1.txt"), HasSubstr("COMPONENTS roscpp tzc)"));
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

/// The command of a text's last line; what the user is to type stands behind "type: ".
std::string last_command(const std::string& text) {
  const std::size_t line = text.rfind('\n', text.size() - 2), begin = text.find("type: ", line);
  return begin == std::string::npos ? "" : text.substr(begin + 6, text.size() - begin - 7);
}

TEST_F(Cli, undo_without_apply_ends_with_the_line_that_undoes) {
  const std::string file = ws.folder() / "it's mine.patch", before = ws.file("src/node.cpp");
  for (const std::string& folder : {ws.package(), ws.folder() / "ws/src", ws.folder() / "ws"}) {
    const auto none = ws.run({"--undo", file, folder});
    EXPECT_EQ(none.status, 2);
    EXPECT_THAT(last_command(none.errors), StartsWith("tzc-rewrite --apply --undo "));
    ASSERT_EQ(ws.run({"--apply", "--undo", file, folder}).status, 0);
    ASSERT_TRUE(is_ported());
    for (const char* action : {"-q", "--check", "--no-cache"}) {
      const auto asked = ws.run({action, "--undo", file, folder});
      EXPECT_EQ(asked.status, 2);
      EXPECT_THAT(asked.output, IsEmpty()) << "git apply would take it";
      EXPECT_THAT(asked.errors, HasSubstr("\n  nothing was undone; type: patch -p1"));
      ASSERT_TRUE(is_ported());
    }
    ASSERT_EQ(ws.shell(last_command(ws.run({"--undo", file, folder}).errors)), 0);
    EXPECT_EQ(ws.file("src/node.cpp"), before);
    EXPECT_THAT(ws.run({"--undo", file, folder}).errors, HasSubstr("does not fit")) << "undone already";
    std::filesystem::remove(file);
  }
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

TEST_F(Cli, no_place_for_the_undo_patch_is_a_warning_where_git_has_the_files) {
  ws.rewrite({});
  ASSERT_EQ(ws.shell("git init -q . && git add -A && git -c user.name=a -c user.email=a@b commit -qm x"), 0);
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

}  // namespace
}  // namespace tzc::rewriter
