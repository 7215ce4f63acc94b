// SPDX-License-Identifier: BSD-3-Clause
// The whole tool, engine included, on the sample package: what the demo promises.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <utility>

#include "model/codes.h"
#include "proof/process.h"
#include "support/temp_dir.h"

namespace tzc::rewriter {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using test::TempDir;
using ::testing::AllOf;
using ::testing::HasSubstr;

/// A run takes many seconds: the port is made once, and each test begins with the workspace before it or after it. All are
/// at one place, because the compile database names it.
class CameraPair : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = std::make_unique<TempDir>();
    fs::create_directories(workspace() / "src");
    fs::copy(SAMPLE_DIR, package(), fs::copy_options::recursive);
    json database = json::array();
    for (const char* unit : {"camera_main", "camera_node", "viewer_node"}) {
      const std::string file = package() + "/src/" + unit + ".cpp";
      const std::string target = std::string(unit) == "viewer_node" ? "viewer_node" : "camera_node";
      database.push_back(
          {{"directory", folder_->path()},
           {"file", file},
           {"command", "/usr/bin/c++ " INCLUDE_FLAGS " -std=gnu++17 -o camera_pair/CMakeFiles/" + target +
                           ".dir/src/" + unit + ".cpp.o -c " + file}});
    }
    folder_->write("ws/build/compile_commands.json", database.dump());
    fs::copy(workspace(), *folder_ / "original", fs::copy_options::recursive);
    shown_ = rewrite({});
    fs::copy_file(*folder_ / "report.json", *folder_ / "baseline.json");
    applied_ = rewrite({"--apply"});
    fs::copy(workspace(), *folder_ / "ported", fs::copy_options::recursive);
  }
  static void TearDownTestSuite() { folder_.reset(); }

  void SetUp() override { begin_with("original"); }

  static void begin_with(const std::string& state) {
    fs::remove_all(workspace());
    fs::copy(*folder_ / state, workspace(), fs::copy_options::recursive);
  }

  static fs::path workspace() { return *folder_ / "ws"; }
  static std::string package() { return workspace() / "src/camera_pair"; }

  static ProcessResult rewrite(std::vector<std::string> words) {
    words.insert(words.begin(), TZC_REWRITE);
    words.insert(words.end(), {"--verify=source", "--report", *folder_ / "report.json", package()});
    return run_process(words);
  }
  static json report(const std::string& name = "report.json") { return json::parse(folder_->read(name)); }

  /// "kind level" of each site, sorted.
  static std::string sites(const json& document) {
    std::set<std::string> all;
    for (const json& site : document["sites"])
      all.insert(site["kind"].get<std::string>() + " " + site["level"].get<std::string>());
    std::ostringstream text;
    for (const std::string& site : all) text << site << "\n";
    return text.str();
  }

  /// Every file of the package with its content and the time of its last change.
  static std::map<std::string, std::pair<std::string, fs::file_time_type>> files() {
    std::map<std::string, std::pair<std::string, fs::file_time_type>> all;
    for (const auto& entry : fs::recursive_directory_iterator(package())) {
      const std::string name = fs::relative(entry.path(), package()).string();
      if (entry.is_regular_file())
        all[name] = {folder_->read("ws/src/camera_pair/" + name), entry.last_write_time()};
    }
    return all;
  }

  /// Applies the port a second time: not a byte changes, nor is a file written anew.
  void apply_again() {
    const auto once = files();
    ASSERT_THAT(once.at("src/camera_node.cpp").first, HasSubstr("tzc::advertise"));
    ASSERT_THAT(once.at("CMakeLists.txt").first, HasSubstr("tzc"));
    ASSERT_THAT(once.at("package.xml").first, HasSubstr("<depend>tzc</depend>"));
    const ProcessResult second = rewrite({"--apply"});
    EXPECT_EQ(second.status, 0) << second.errors;
    const auto twice = files();
    for (const auto& [name, file] : twice) {
      ASSERT_EQ(once.count(name), 1u) << name << " was not there";
      EXPECT_EQ(file.first, once.at(name).first) << name;
      EXPECT_EQ(file.second, once.at(name).second) << name << " was written again";
    }
    EXPECT_EQ(twice.size(), once.size());
  }

  static std::set<std::string> ids(const json& document) {
    std::set<std::string> all;
    for (const json& site : document["sites"]) all.insert(site["id"]);
    return all;
  }

  static inline std::unique_ptr<TempDir> folder_;
  static inline ProcessResult shown_, applied_;
};

TEST_F(CameraPair, every_site_is_ported_as_far_as_possible) {
  EXPECT_EQ(shown_.status, 1) << shown_.errors;
  EXPECT_EQ(sites(report("baseline.json")), "advertise zero_copy\npublish zero_copy\nsubscribe shared\n");
  EXPECT_EQ(report("baseline.json")["summary"]["files_changed"], 5);
  EXPECT_THAT(shown_.output, HasSubstr("+  tzc::Publisher publisher_;\n"));
  EXPECT_EQ(applied_.status, 0) << applied_.errors;
}

TEST_F(CameraPair, the_second_run_changes_nothing_and_reports_the_same) {
  begin_with("ported");
  const json first = report("baseline.json");
  const ProcessResult second = rewrite({});
  EXPECT_EQ(second.status, 0) << second.errors;
  EXPECT_EQ(second.output, "");
  EXPECT_EQ(report()["summary"]["files_changed"], 0);
  for (const char* kind : {"publish", "subscribe"})
    EXPECT_EQ(report()["summary"][kind], first["summary"][kind]) << kind;
  EXPECT_EQ(ids(report()), ids(first));
}

TEST_F(CameraPair, applied_twice_is_applied_once) {
  begin_with("ported");
  apply_again();
}

/// What the first run wrote is not committed yet; there is nothing to write over it.
TEST_F(CameraPair, applied_twice_in_a_git_repository) {
  const std::string source = workspace() / "src";
  const std::string git = "git -C " + source + " -c user.name=n -c user.email=n@example.org ";
  ASSERT_EQ(std::system((git + "init -q && " + git + "add -A && " + git + "commit -q -m all").c_str()), 0);
  fs::copy(*folder_ / "ported/src", source,
           fs::copy_options::recursive | fs::copy_options::overwrite_existing);
  apply_again();
}

TEST_F(CameraPair, a_report_from_before_the_port_is_a_baseline_after_it) {
  begin_with("ported");
  const ProcessResult check = rewrite({"--check", "--baseline", *folder_ / "baseline.json"});
  EXPECT_EQ(check.status, 0) << check.output << check.errors;
}

/// The publisher is ported, the subscriber is not: the file for code scanning has the latter alone.
TEST_F(CameraPair, only_what_the_port_would_still_change_is_pending) {
  const std::string viewer = "src/camera_pair/src/viewer_node.cpp";
  const auto pending_files = [&] {
    rewrite({"--check", "--report", *folder_ / "tzc.sarif"});
    const json log = json::parse(folder_->read("tzc.sarif"));
    std::set<std::string> names;
    for (const json& result : log["runs"][0]["results"])
      if (result["ruleId"] == codes::TZC5001)
        names.insert(
            fs::path(result["locations"][0]["physicalLocation"]["artifactLocation"]["uri"].get<std::string>())
                .filename());
    return names;
  };
  EXPECT_EQ(pending_files(), (std::set<std::string>{"camera_node.cpp", "viewer_node.cpp"}));
  begin_with("ported");
  EXPECT_EQ(pending_files(), std::set<std::string>());
  folder_->write("ws/" + viewer, folder_->read("original/" + viewer));
  EXPECT_EQ(pending_files(), std::set<std::string>{"viewer_node.cpp"});
}

TEST_F(CameraPair, a_file_that_does_not_parse_is_left_out_and_named) {
  const std::string broken =
      folder_->read("ws/src/camera_pair/src/viewer_node.cpp") + "\nint missing = undeclared;\n";
  folder_->write("ws/src/camera_pair/src/viewer_node.cpp", broken);
  const ProcessResult result = rewrite({"--apply"});
  EXPECT_EQ(result.status, 0) << result.errors;
  EXPECT_THAT(result.output, AllOf(HasSubstr("TZC3003"), HasSubstr("viewer_node.cpp"))) << result.errors;
  EXPECT_EQ(folder_->read("ws/src/camera_pair/src/viewer_node.cpp"), broken);
  EXPECT_THAT(folder_->read("ws/src/camera_pair/src/camera_node.h"), HasSubstr("tzc::Publisher publisher_"));
}

TEST_F(CameraPair, a_file_that_does_not_parse_stops_a_strict_run_and_nothing_is_written) {
  const std::string broken =
      folder_->read("ws/src/camera_pair/src/viewer_node.cpp") + "\nint missing = undeclared;\n";
  folder_->write("ws/src/camera_pair/src/viewer_node.cpp", broken);
  const ProcessResult result = rewrite({"--apply", "--strict"});
  EXPECT_EQ(result.status, 2);
  EXPECT_THAT(result.errors, HasSubstr("viewer_node.cpp:"));
  EXPECT_THAT(result.errors, HasSubstr("undeclared"));
  EXPECT_EQ(folder_->read("ws/src/camera_pair/src/viewer_node.cpp"), broken);
  EXPECT_THAT(folder_->read("ws/src/camera_pair/src/camera_node.h"), HasSubstr("ros::Publisher publisher_"));
}

}  // namespace
}  // namespace tzc::rewriter
