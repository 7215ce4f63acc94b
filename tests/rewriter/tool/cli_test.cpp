// SPDX-License-Identifier: BSD-3-Clause
// The program as its user meets it: its options, what it prints where, how it ends.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tool/cli_case.h"

namespace tzc::rewriter {
namespace {

using nlohmann::json;
using test::Cli;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;

TEST_F(Cli, json_report) {
  ws.rewrite({"--report", ws.folder() / "r.json"});
  const json report = json::parse(ws.folder().read("r.json"));
  EXPECT_EQ(report["version"], 1);
  EXPECT_EQ(report["package"], "demo");
  EXPECT_EQ(report["sites"][0]["file"], "src/node.cpp");
  EXPECT_EQ(report["sites"][0]["topic"], "image");
  EXPECT_EQ(report["summary"]["files_changed"], 3);
}

TEST_F(Cli, the_page_says_whether_anything_was_written) {
  const std::string page = ws.folder() / "r.html";
  const std::vector<std::string> actions[] = {
      {}, {"--check"}, {"--out-dir", ws.folder() / "out"}, {"--apply"}};
  for (const std::vector<std::string>& words : actions) {
    std::vector<std::string> all = {"--report", page};
    all.insert(all.end(), words.begin(), words.end());
    ws.rewrite(all);
    const bool writes = !words.empty() && words[0] != "--check";
    const std::string text = ws.folder().read("r.html");
    EXPECT_EQ(text.find("site of the package is ported") != std::string::npos, writes);
    EXPECT_EQ(text.find("can be ported; nothing was written") != std::string::npos, !writes);
  }
}

TEST_F(Cli, options_reach_the_engine) {
  ws.plan()["echo"] = true;
  EXPECT_THAT(
      ws.rewrite({"--level=one_copy", "--on-exhausted=drop", "--mem-size=64M", "--dual", "-j", "3"}).errors,
      HasSubstr("level=one_copy on_exhausted=1 mem_size=67108864 dual=true jobs=3"));
}

TEST_F(Cli, nothing_works_with_no_jobs_or_a_million) {
  for (const std::string jobs : {"0", "-1", "1000000"}) EXPECT_EQ(ws.rewrite({"-j", jobs}).status, 2) << jobs;
}

TEST_F(Cli, small_is_a_page_unless_said) {
  ws.plan()["echo"] = true;
  EXPECT_THAT(ws.rewrite({}).errors, HasSubstr("small=4096"));
  EXPECT_THAT(ws.rewrite({"--small=64K"}).errors, HasSubstr("small=65536"));
  EXPECT_THAT(ws.rewrite({"--small=0"}).errors, HasSubstr("small=0"));
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

struct Mistake {
  std::vector<std::string> words;
  const char* says;
};

TEST_F(Cli, mistakes_on_the_command_line) {
  const Mistake mistakes[] = {{{"--bogus"}, "--bogus"},
                              {{"--report", "r.txt"}, "a report ends in .json, .sarif or .html"},
                              {{"--only", "node=x"}, "topic=GLOB"},
                              {{"--mem-size", "lots"}, "a size is a number of bytes"},
                              {{"--small", "tiny"}, "a size is a number of bytes"},
                              {{"--level", "best"}, "--level"},
                              {{"--cache-dir=", "--check"}, "--cache-dir=: a value is missing"},
                              {{"--apply", "--check"}, ""},
                              {{"/nonexistent"}, "is no folder"},
                              {{"-p", "/nonexistent"}, "/nonexistent: is no folder"},
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

TEST_F(Cli, a_filter_that_matches_nothing_is_warned_about) {
  EXPECT_THAT(ws.rewrite({"--only=topic=imgae"}).errors,
              HasSubstr("warning: --only topic=imgae matches no site"));
  EXPECT_THAT(ws.rewrite({"--only=topic=image"}).errors, Not(HasSubstr("matches no site")));
  const auto check = ws.rewrite({"--check", "--only=topic=imgae"});
  EXPECT_THAT(check.errors, HasSubstr("error: --only topic=imgae matches no site"));
  EXPECT_EQ(check.status, 2) << "a check of nothing would pass";
  ws.plan()["error"] = "does not compile";
  EXPECT_THAT(ws.rewrite({"--only=topic=imgae"}).errors, Not(HasSubstr("matches no site")))
      << "not looked at";
}

/// Whatever an output option names, a place that takes no output is known before the analysis.
TEST_F(Cli, a_report_that_cannot_be_written_is_known_before_the_analysis) {
  const auto& folder = ws.folder();
  for (const char* name : {"is_a.json", "is_a.sarif", "is_a.html", "out/demo.d"})
    std::filesystem::create_directories(folder / name);
  ASSERT_EQ(ws.shell("mkfifo ../pipe"), 0);
  folder.write("a_file", "");
  folder.write("taken/demo", "");
  const Mistake mistakes[] = {
      {{"--apply", "--report", folder / "missing/r.json"}, "missing/r.json"},
      {{"--apply", "--report", folder / "a_file/r.json"}, "a_file/r.json"},
      {{"--apply", "--report", folder / "is_a.json"}, "is_a.json: is a folder"},
      {{"--apply", "--report", folder / "is_a.sarif"}, "is_a.sarif: is a folder"},
      {{"--apply", "--report", folder / "is_a.html"}, "is_a.html: is a folder"},
      {{"--apply", "--report", folder / "r.json", "--report", folder / "out/../r.json"}, "is named twice"},
      {{"--apply", "--undo", folder / "is_a.json"}, "is_a.json: is no regular file"},
      {{"--apply", "--undo", folder / "pipe"}, "pipe: is no regular file"},
      {{"--out-dir", folder / "a_file"}, "a_file"},
      {{"--out-dir", folder / "taken"}, "taken/demo: is no folder"},
  };
  ws.plan()["echo"] = true;
  for (const Mistake& mistake : mistakes) {
    const auto result = ws.rewrite(mistake.words);
    EXPECT_EQ(result.status, 2) << mistake.says;
    EXPECT_THAT(result.errors, HasSubstr(mistake.says));
    EXPECT_THAT(result.errors, Not(HasSubstr("engine:"))) << "the analysis began";
    EXPECT_FALSE(is_ported()) << mistake.says;
  }
  EXPECT_THAT(ws.rewrite({}).errors, HasSubstr("engine:"));
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

TEST_F(Cli, progress_in_a_log_is_a_line_for_each_stage) {
  ws.plan()["progress"] = 3;
  EXPECT_THAT(ws.rewrite({}).errors,
              HasSubstr("tzc-rewrite: parsing 1/3 node.cpp\ntzc-rewrite: parsing 3/3 node.cpp\n"));
  EXPECT_THAT(ws.rewrite({"-q"}).errors, IsEmpty());
}

}  // namespace
}  // namespace tzc::rewriter
