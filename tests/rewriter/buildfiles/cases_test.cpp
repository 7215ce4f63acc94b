// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "buildfiles/plan.h"
#include "edits/apply.h"
#include "edits/diff.h"
#include "edits/files.h"
#include "support/golden_case.h"
#include "support/temp_dir.h"

namespace tzc::rewriter {
namespace {

using nlohmann::json;
constexpr const char* default_package_xml = R"(<package format="2">
  <name>demo</name>
  <buildtool_depend>catkin</buildtool_depend>
  <depend>roscpp</depend>
</package>
)";

std::string with_crlf(const std::string& text) {
  std::string result;
  for (const char c : text) result += c == '\n' ? std::string("\r\n") : std::string(1, c);
  return result;
}

/// One .case file. Its section "uses" says what the port needs:
///   target NAME FILE   FILE is compiled by the target NAME and ported
///   edited FILE        a header that the port changes
///   type PKG/TYPE      a twin that the ported code includes
///   twinless PKG       a package of such twins whose build makes none
///   dual               the package must still build without TZC
///   crlf               the package's files have Windows line endings
class BuildFilesCase : public ::testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    read_uses();
    write_package();
    needs_.package_dir = needs_.build_dir = package_.path();
  }

  void read_uses() {
    std::istringstream uses(case_.section("uses"));
    for (std::string word; uses >> word;) {
      std::string name, file;
      if (word == "target" && uses >> name >> file) add_target(name, package_ / file);
      if (word == "edited" && uses >> file) needs_.edited_files.insert(package_ / file);
      if (word == "type" && uses >> name) needs_.tzc_types.insert(name);
      if (word == "twinless" && uses >> name) needs_.twinless.insert(name);
      needs_.dual |= word == "dual";
      crlf_ |= word == "crlf";
    }
    package_.write("compile_commands.json", database_.dump());
  }

  void add_target(const std::string& name, const std::string& file) {
    database_.push_back({{"directory", package_.path()},
                         {"file", file},
                         {"command", "c++ -o demo/CMakeFiles/" + name + ".dir/x.cpp.o -c " + file}});
    needs_.main_files.insert(file);
  }

  void write_package() {
    package_.write("package.xml", crlf_ ? with_crlf(default_package_xml) : default_package_xml);
    for (const auto& [name, text] : case_.sections())
      if (name != "uses") package_.write(name, crlf_ ? with_crlf(text) : text);
  }

  /// The plan as text: the diff, then the notes. Leaves the edits applied.
  std::string outcome() {
    const Expected<BuildPlan> plan = plan_build_files(needs_);
    if (!plan) return "error: " + without_path(to_string(plan.error())) + "\n";
    std::string text;
    for (const auto& [file, edits] : by_file(plan->edits)) text += applied_diff(file, edits);
    for (const Note& note : plan->notes) text += note.code + ": " + note.text + "\n";
    return text;
  }

  std::string applied_diff(const std::string& file, const Edits& edits) {
    const std::string before = *read_file(file);
    const Expected<std::string> after = apply_edits(before, edits);
    if (!after) return "error: " + to_string(after.error()) + "\n";
    const std::string name = file.substr(package_.path().size() + 1);
    package_.write(name, *after);
    std::string diff = unified_diff(name, before, *after, false).text;
    diff.erase(std::remove(diff.begin(), diff.end(), '\r'), diff.end());
    crs_kept_ &= !crlf_ || after->find("\r\n") != std::string::npos;
    crs_kept_ &= std::count(after->begin(), after->end(), '\r') ==
                 (crlf_ ? std::count(after->begin(), after->end(), '\n') : 0);
    return diff;
  }

  std::string without_path(std::string text) const {
    for (std::size_t at; (at = text.find(package_.path())) != std::string::npos;)
      text.replace(at, package_.path().size(), "PACKAGE");
    return text;
  }

  tzc::test::GoldenCase case_{GetParam()};
  tzc::test::TempDir package_;
  json database_ = json::array();
  BuildNeeds needs_;
  bool crlf_ = false, crs_kept_ = true;
};

TEST_P(BuildFilesCase, comes_out_as_written_down_and_a_second_run_changes_nothing) {
  const std::string first = outcome();
  EXPECT_EQ(first, case_.expected(first));
  EXPECT_TRUE(crs_kept_) << "line endings are mixed now";
  EXPECT_EQ(outcome().find("@@"), std::string::npos) << "the second run has edits";
}

INSTANTIATE_TEST_SUITE_P(BuildFiles, BuildFilesCase,
                         ::testing::ValuesIn(tzc::test::GoldenCase::all(CASES_DIR, ".case")),
                         [](const auto& info) {
                           return tzc::test::GoldenCase::test_name(CASES_DIR, info.param);
                         });

}  // namespace
}  // namespace tzc::rewriter
