// SPDX-License-Identifier: BSD-3-Clause
// A second run over what has not changed: quick, the same to the byte; and every kind of change is seen.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <thread>

#include "cache/result_store.h"
#include "edits/files.h"
#include "port/cache_inputs.h"
#include "port/port_record.h"
#include "tool/workspace.h"

namespace tzc::rewriter {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using ::testing::HasSubstr;

class Cache : public ::testing::Test {
 protected:
  Cache() {
    ws.plan()["progress"] = 1;
    header_ = ws.folder().write("system/include/lib.h", "int lib();");
    absent_ = ws.folder() / "early/include/lib.h";
    ws.plan()["reads"] = {header_, absent_};
  }

  ProcessResult check(std::vector<std::string> words = {"--check"},
                      std::map<std::string, std::string> environment = {}) {
    std::this_thread::sleep_for(std::chrono::milliseconds(30));  // file times count in ticks
    words.insert(words.begin(), {"--cache-dir", ws.folder() / "cache"});
    return ws.rewrite(std::move(words), std::move(environment));
  }
  static bool is_hit(const ProcessResult& result) {
    return result.errors.find("parsing") == std::string::npos;
  }

  /// A first run, a second that hits, the change, and a third that must not; then it is kept again.
  void expect_seen(const std::string& what, const std::function<void()>& change) {
    check();
    EXPECT_TRUE(is_hit(check())) << what;
    change();
    EXPECT_FALSE(is_hit(check())) << what;
    EXPECT_TRUE(is_hit(check())) << what;
  }

  test::Workspace ws;
  std::string header_, absent_;
};

TEST_F(Cache, a_second_check_says_the_same_without_an_analysis) {
  const std::string report = ws.folder() / "r.json";
  const auto first = check({"--check", "--report", report});
  const std::string text = ws.folder().read("r.json");
  const auto second = check({"--check", "--report", report});
  EXPECT_FALSE(is_hit(first));
  EXPECT_TRUE(is_hit(second)) << second.errors;
  EXPECT_EQ(second.status, first.status);
  EXPECT_EQ(second.output, first.output);
  EXPECT_EQ(ws.folder().read("r.json"), text);
  EXPECT_TRUE(is_hit(check({"--check", "--report", ws.folder() / "tzc.sarif"})))
      << "another report of the same";
  EXPECT_THAT(ws.folder().read("tzc.sarif"), HasSubstr("TZC5001"));
  const auto dry = check({});
  EXPECT_TRUE(is_hit(dry));
  EXPECT_THAT(dry.output, HasSubstr("+tzc::Publisher pub;"));
}

TEST_F(Cache, every_kind_of_change_is_seen) {
  const auto write = [&](const std::string& name, const std::string& text) {
    return [this, name, text] { ws.folder().write(name, text); };
  };
  expect_seen("a source",
              write("ws/src/demo/src/node.cpp", "#include <ros/ros.h>\nros::Publisher pub; // x\n"));
  expect_seen("a new file", write("ws/src/demo/src/new.h", ""));
  expect_seen("a removed file", [&] {
    ws.folder().write("ws/src/demo/src/node.cpp", "#include <ros/ros.h>\nros::Publisher pub; // y\n");
    check();
    fs::remove(ws.package() + "/src/new.h");
  });
  expect_seen("a renamed file", [&] {
    ws.folder().write("ws/src/demo/src/a.h", "same");
    check();
    fs::rename(ws.package() + "/src/a.h", ws.package() + "/src/b.h");
  });
  expect_seen("package.xml",
              [&] { ws.folder().write("ws/src/demo/package.xml", ws.file("package.xml") + "<!-- x -->\n"); });
  expect_seen("CMakeLists.txt",
              [&] { ws.folder().write("ws/src/demo/CMakeLists.txt", ws.file("CMakeLists.txt") + "# x\n"); });
  expect_seen("a header elsewhere", write("system/include/lib.h", "int lib(int);"));
  expect_seen("a header that is found earlier", write("early/include/lib.h", "int other();"));
  expect_seen("it vanishes", [&] { fs::remove(absent_); });
  expect_seen("a header is a link now", [&] {
    fs::rename(header_, ws.folder() / "moved.h");
    fs::create_symlink(ws.folder() / "moved.h", header_);
  });
  expect_seen("the compile commands", [&] {
    json database = json::parse(ws.folder().read("ws/build/compile_commands.json"));
    database[0]["command"] = database[0]["command"].get<std::string>() + " -DX";
    ws.folder().write("ws/build/compile_commands.json", database.dump());
  });
  expect_seen("CMake's cache", write("ws/build/CMakeCache.txt", "X:BOOL=ON\n"));
  expect_seen("a style above the package", write("ws/.clang-format", "BasedOnStyle: Google\n"));
  expect_seen("trusted functions above the workspace", write(".tzc-rewrite.yaml", "keeps_nothing: []\n"));
  expect_seen("TZC's headers", [&] {
    ws.plan()["reads"].push_back(ws.folder() / "include/tzc/ros.h");
    check();
    ws.folder().write("include/tzc/ros.h", "// x\n");
  });
}

TEST_F(Cache, packages_behind_links_of_the_workspace_count) {
  const std::string other = ws.folder() / "elsewhere/other";
  ws.folder().write("elsewhere/other/package.xml", "<package format=\"2\"><name>other</name></package>");
  fs::create_directory_symlink(other, ws.folder() / "ws/src/other");
  expect_seen("a header there", [&] { ws.folder().write("elsewhere/other/include/a.h", ""); });
}

TEST_F(Cache, response_files_count) {
  json database = json::parse(ws.folder().read("ws/build/compile_commands.json"));
  database[0]["command"] = "c++ @flags.rsp -o demo/CMakeFiles/node.dir/src/node.cpp.o -c x";
  ws.folder().write("ws/build/compile_commands.json", database.dump());
  ws.folder().write("flags.rsp", "-DX");  // the commands' folder
  expect_seen("its flags", [&] { ws.folder().write("flags.rsp", "-DY"); });
}

TEST_F(Cache, sources_count_where_the_build_folder_is_theirs) {
  ws.database("ws/src/demo");
  ws.folder().write("ws/src/demo/CMakeFiles/x.h", "");
  expect_seen("a source",
              [&] { ws.folder().write("ws/src/demo/src/node.cpp", "ros::Publisher pub; // x\n"); });
  expect_seen("a header that is found earlier", [&] { ws.folder().write("ws/src/demo/include/lib.h", ""); });
  check();
  ws.folder().write("ws/src/demo/CMakeFiles/x.h", "// made again\n");
  EXPECT_TRUE(is_hit(check())) << "what CMake makes";
}

/// Same size, same modification time: the content counts.
TEST_F(Cache, a_change_that_hides_is_seen) {
  expect_seen("same size and time", [&] {
    const auto time = fs::last_write_time(header_);
    ws.folder().write("system/include/lib.h", "int lab();");
    fs::last_write_time(header_, time);
  });
}

TEST_F(Cache, options_and_environment_have_results_of_their_own) {
  check();
  for (const std::vector<std::string>& words : {std::vector<std::string>{"--check", "--level=one_copy"},
                                                {"--check", "--only=topic=x"},
                                                {"--check", "--dual"},
                                                {"--check", "--strict"},
                                                {"--check", "--mem-size=1M"},
                                                {"--check", "--small=1K"},
                                                {"--check", "--on-exhausted=drop"},
                                                {"--check", "--except=type=x/*"},
                                                {"--check", "--verify=syntax"}}) {
    EXPECT_FALSE(is_hit(check(words))) << words[1];
    EXPECT_TRUE(is_hit(check())) << words[1];
  }
  EXPECT_FALSE(is_hit(check({"--check"}, {{"CPATH", "/somewhere"}})));
  EXPECT_TRUE(is_hit(check({"--check"}, {{"TERM", "dumb"}, {"GITHUB_RUN_ID", "7"}, {"CI_JOB_ID", "7"}})))
      << "no compiler reads these";
  for (const char* name :
       {"SHLVL", "BUILD_NUMBER", "GIT_AUTHOR_DATE", "GNOME_TERMINAL_SCREEN", "VSCODE_IPC_HOOK"})
    EXPECT_TRUE(is_session_variable(name)) << name;
  for (const char* name : {"CPATH", "PATH", "CXX", "ROS_PACKAGE_PATH", "LD_LIBRARY_PATH", "HOME", "LANG"})
    EXPECT_FALSE(is_session_variable(name)) << name;
}

TEST_F(Cache, holds_no_password_and_is_its_owners_alone) {
  const std::string old = ws.folder().write("cache/0.result", "kept by an earlier tzc-rewrite");
  check({"--check"}, {{"CLOUD_SECRET_KEY", "hunter2"}});
  EXPECT_TRUE(is_hit(check({"--check"}, {{"CLOUD_SECRET_KEY", "hunter2"}})));
  EXPECT_FALSE(is_hit(check({"--check"}, {{"CLOUD_SECRET_KEY", "hunter3"}})));
  std::size_t entries = 0;
  for (const auto& entry : fs::directory_iterator(ws.folder() / "cache")) {
    EXPECT_THAT(*read_file(entry.path()), ::testing::Not(HasSubstr("hunter")));
    EXPECT_EQ(entry.status().permissions(), fs::perms::owner_read | fs::perms::owner_write);
    ++entries;
  }
  EXPECT_EQ(entries, 2u);
  EXPECT_FALSE(fs::exists(old));
}

TEST_F(Cache, what_changes_during_a_run_is_not_kept) {
  ws.plan()["touch"] = "../../../system/include/lib.h";
  check();
  EXPECT_FALSE(is_hit(check()));
}

TEST_F(Cache, errors_are_not_kept) {
  ws.plan()["error"] = "does not compile";
  check();
  EXPECT_EQ(check().status, 2);
  EXPECT_FALSE(fs::exists(ws.folder() / "cache"));
}

TEST_F(Cache, is_neither_read_nor_written_by_runs_that_write_or_do_not_want_it) {
  check();
  EXPECT_FALSE(is_hit(check({"--check", "--no-cache"})));
  EXPECT_FALSE(is_hit(check({"--out-dir", ws.folder() / "out"})));
  EXPECT_FALSE(is_hit(check({"--apply"})));
  EXPECT_THAT(ws.file("src/node.cpp"), HasSubstr("tzc::Publisher"));
  const auto after = check();
  EXPECT_EQ(after.status, 0) << "the port is seen";
}

TEST_F(Cache, a_folder_that_cannot_be_used_is_no_error) {
  ws.folder().write("cache", "a file, not a folder");
  for (int i = 0; i < 2; ++i) EXPECT_EQ(check().status, 1);
  EXPECT_EQ(ws.folder().read("cache"), "a file, not a folder");
}

TEST_F(Cache, damaged_entries_are_no_entries) {
  const auto first = check();
  for (const auto& entry : fs::directory_iterator(ws.folder() / "cache")) {
    std::string bytes = ws.folder().read("cache/" + entry.path().filename().string());
    bytes[bytes.size() / 2] ^= 1;
    ws.folder().write("cache/" + entry.path().filename().string(), bytes);
  }
  const auto second = check();
  EXPECT_FALSE(is_hit(second));
  EXPECT_EQ(second.output, first.output);
  EXPECT_TRUE(is_hit(check())) << "it is made anew";
  for (const auto& entry : fs::directory_iterator(ws.folder() / "cache")) fs::resize_file(entry.path(), 100);
  EXPECT_FALSE(is_hit(check()));
}

std::string digest(std::string_view text) {
  return std::to_string(std::hash<std::string_view>()(text));
}

TEST(ResultStore, keeps_the_entries_that_were_used_last) {
  const tzc::test::TempDir folder;
  const ResultStore store(folder / "cache", digest, 10000);
  for (int i = 0; i < 12; ++i) {
    store.keep("key " + std::to_string(i), std::string(1500, 'x'));
    EXPECT_TRUE(store.find("key 0")) << "used all the time";
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  EXPECT_TRUE(store.find("key 11"));
  EXPECT_FALSE(store.find("key 3"));
  std::uintmax_t total = 0;
  for (const auto& entry : fs::directory_iterator(folder / "cache")) total += entry.file_size();
  EXPECT_LE(total, 10000u);
  store.keep("large", std::string(20000, 'x'));
  EXPECT_FALSE(store.find("large"));
}

TEST(ResultStore, keys_with_one_digest_are_told_apart) {
  const tzc::test::TempDir folder;
  const ResultStore store(folder / "cache", [](std::string_view) { return std::string("same"); });
  store.keep("one", "1");
  EXPECT_EQ(store.find("one"), "1");
  EXPECT_FALSE(store.find("two"));
}

TEST(ResultStore, runs_that_were_killed_leave_nothing_for_long) {
  const tzc::test::TempDir folder;
  const std::string young = folder.write("cache/a.result-1.part", "half");
  const std::string old = folder.write("cache/b.result-2.part", "half");
  fs::last_write_time(old, fs::file_time_type::clock::now() - std::chrono::hours(2));
  ResultStore(folder / "cache", digest).keep("key", "result");
  EXPECT_TRUE(fs::exists(young));
  EXPECT_FALSE(fs::exists(old));
}

TEST(ResultStore, many_runs_at_once) {
  const tzc::test::TempDir folder;
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t)
    threads.emplace_back([&] {
      const ResultStore store(folder / "cache", digest, 4000);
      for (int i = 0; i < 200; ++i) {
        const std::string key = std::to_string(i % 5);
        store.keep(key, std::string(1000, key[0]));
        const auto found = store.find(key);
        EXPECT_TRUE(!found || *found == std::string(1000, key[0]));
      }
    });
  for (std::thread& thread : threads) thread.join();
}

TEST(PortRecord, comes_back_as_it_was_byte_by_byte) {
  PackagePort port;
  port.package_dir = "/ws/src/demo";
  port.contents["/ws/src/demo/a.cpp"] = std::string("\xff\xfe\0x", 4);
  port.result.changes = {{"a.cpp", "\xe9\r\n", "x"}};
  port.result.report.sites.resize(1);
  port.result.report.sites[0].topic = "image";
  port.result.report.sites[0].flow_path = {{{"f", 1, 2}, "w"}};
  port.result.report.sites[0].pending = true;
  port.result.report.notes = {{"TZC3001", Location{"f", 3, 4}, "t"}, {"TZC3002", std::nullopt, "u"}};
  port.result.pending = {{"TZC5001", {"f", 5, 6}, "p", "id"}};
  port.units = {"u"};
  port.hints = {{"TZC4001", std::nullopt, "h"}};
  port.refused = true;
  const PortRecord record{{{{"/p", Access::tree}, "state"}}, {port}};
  const auto back = decoded(encoded(record));
  ASSERT_TRUE(back);
  EXPECT_EQ(encoded(*back), encoded(record));
  EXPECT_EQ(back->ports[0].contents, port.contents);
  EXPECT_EQ(back->ports[0].result.changes[0].before, "\xe9\r\n");
  EXPECT_FALSE(back->ports[0].result.report.notes[1].where);
  EXPECT_FALSE(decoded("nonsense"));
}

}  // namespace
}  // namespace tzc::rewriter
