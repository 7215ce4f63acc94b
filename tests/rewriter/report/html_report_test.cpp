// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <regex>

#include "report/estimate.h"
#include "sample.h"
#include "support/golden_case.h"

namespace tzc::rewriter {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::Not;

const RunInfo info{"1.2.3", "2026-01-02 03:04 UTC", "tzc-rewrite --report 'my port.html' <src>"};

TEST(HtmlReport, golden_body) {
  const std::string page = to_html({test::sample()}, info);
  const std::string body = page.substr(page.find("<body>"));
  EXPECT_EQ(body, tzc::test::golden_file(GOLDEN_DIR "/report_body.html", body));
}
TEST(HtmlReport, needs_nothing_else) {
  const std::string page = to_html({test::sample()}, info);
  for (const char* reference : {"http://", "https://", "src=", "@import", "url("})
    EXPECT_THAT(page, Not(HasSubstr(reference)));
}
TEST(HtmlReport, escapes_what_comes_from_the_source) {
  PackageReport package = test::sample();
  package.report.sites[0].topic = "<script>alert(1)</script>";
  package.changes[0].after = "<script>";
  const std::string page = to_html({package}, info);
  EXPECT_THAT(page, Not(HasSubstr("<script>")));
  EXPECT_THAT(page, HasSubstr("&lt;src&gt;"));
}
TEST(HtmlReport, every_element_is_closed) {
  const std::string page = to_html({test::sample(), test::sample()}, info);
  for (const char* name :
       {"table",   "tr",      "td",    "th",     "div",    "section", "header", "nav",  "dl", "dt",
        "dd",      "form",    "label", "select", "option", "script",  "h1",     "h2",   "h3", "h4",
        "details", "summary", "ol",    "ul",     "li",     "p",       "span",   "code", "a"}) {
    const auto count = [&](const std::string& pattern) {
      const std::regex regex(pattern);
      return std::distance(std::sregex_iterator(page.begin(), page.end(), regex), std::sregex_iterator());
    };
    EXPECT_EQ(count(std::string("<") + name + "[ >]"), count(std::string("</") + name + ">")) << name;
  }
}

/// Only a port that is in the files is done; what is left does not matter for that.
TEST(HtmlReport, claims_a_port_only_when_it_was_written) {
  for (const bool refusals : {false, true})
    for (const bool changes : {false, true})
      for (const bool written : {false, true}) {
        SCOPED_TRACE(testing::Message() << refusals << changes << written);
        PackageReport package = test::sample();
        if (!refusals)
          for (Site& site : package.report.sites) site.suppressed = true;
        if (!changes) package.changes.clear();
        package.written = written;
        const std::string page = to_html({package}, info);
        const bool only_shown = changes && !written;
        EXPECT_EQ(page.find("nothing was written") != std::string::npos, only_shown);
        EXPECT_EQ(page.find("can be ported") != std::string::npos, only_shown);
        EXPECT_EQ(page.find("site of the package is ported") != std::string::npos, !refusals && !only_shown);
        EXPECT_EQ(page.find("files to change") != std::string::npos, only_shown);
      }
}

TEST(HtmlReport, says_where_it_comes_from) {
  PackageReport package = test::sample();
  package.commit = "0123456789ab with uncommitted changes";
  const std::string page = to_html({package}, info);
  for (const char* text :
       {"1.2.3", "2026-01-02 03:04 UTC", "tzc-rewrite --report", "0123456789ab with uncommitted"})
    EXPECT_THAT(page, HasSubstr(text));
}
TEST(HtmlReport, several_packages_have_a_table_of_contents_with_a_sum) {
  PackageReport other = test::sample();
  other.report.package = "other";
  const std::string page = to_html({test::sample(), other}, info);
  EXPECT_THAT(page, HasSubstr("<h1>TZC port of 2 packages</h1>"));
  for (const char* name : {"demo", "other"}) {
    EXPECT_THAT(page, HasSubstr(std::string("<a href=\"#") + name + "\">"));
    EXPECT_THAT(page, HasSubstr(std::string("id=\"") + name + "\""));
  }
  // Of four sites each: one zero_copy, one one_copy; two are plain, of which one is suppressed.
  EXPECT_THAT(page, HasSubstr("<td>together</td><td class=\"num\">4 of 8</td>"));
  EXPECT_THAT(to_html({test::sample()}, info), Not(HasSubstr("together")));
}
TEST(HtmlReport, estimates_what_the_port_buys_and_what_is_left) {
  PackageReport package = test::sample();
  package.message_sizes["camera/image"] = 6220800;
  const std::vector<SiteEstimate> all = estimates(package);
  ASSERT_EQ(all.size(), 4u) << "publish sites with data";
  EXPECT_EQ(all[0].before, 4u);
  EXPECT_EQ(all[0].after, 0u);
  EXPECT_EQ(all[0].size, 6220800u);
  EXPECT_EQ(all[1].before, 1u) << "not pending: it is one_copy already";
  EXPECT_EQ(sum_of(all).left, 2u);
  const std::string page = to_html({package}, info);
  EXPECT_THAT(page, HasSubstr("<td class=\"num\">6.2 MB</td>"));
  EXPECT_THAT(page, HasSubstr("<td class=\"num\">24.9 MB</td><td class=\"num good\">0</td>"));
}

TEST(TextReport, estimates_by_measured_and_usual_sizes) {
  PackageReport package;
  EXPECT_EQ(text_estimate(package), "") << "nothing is published";
  for (const char* type : {"sensor_msgs/Image", "sensor_msgs/PointCloud2", "vendor_msgs/Blob"}) {
    package.report.sites.push_back(test::site(SiteKind::publish, "src/a.cpp", 1, type, Level::zero_copy));
    package.report.sites.back().pending = true;
    package.report.sites.back().topic = type;
  }
  EXPECT_EQ(text_estimate(package),
            "12 copies now, 0 after; 5.6 MB now, 0 B after (usual sizes), 1 of unknown size not counted");
  package.message_sizes = {{"sensor_msgs/Image", 1000000}, {"vendor_msgs/Blob", 2000000}};
  EXPECT_EQ(text_estimate(package),
            "12 copies now, 0 after; 13.9 MB now, 0 B after (measured and usual sizes)");
  package.report.sites[1].level = Level::not_needed;
  EXPECT_EQ(text_estimate(package), "8 copies now, 0 after; 12.0 MB now, 0 B after (measured)");
}

/// Judged by another reader of UTF-8 than the one that made it.
bool is_utf8(const std::string& text) {
  return !json(text).dump(-1, ' ', false, json::error_handler_t::ignore).empty() && [&] {
    try {
      return !json(text).dump().empty();
    } catch (const json::type_error&) {
      return false;
    }
  }();
}
TEST(HtmlReport, is_utf8_whatever_the_sources_are) {
  PackageReport package = test::sample();
  package.changes[1].before = "// caf\xe9 \xc3\x28 \xed\xa0\x80 \xf5\x80\x80\x80 \xc0\xaf end\n";
  package.changes[1].after = std::string("// gr\xc3\xbc\xc3\x9f \xf0\x9f\x98\x80 \x01 nul: \0.\n", 25);
  package.report.sites[0].reason = "\xff";
  const std::string page = to_html({package}, info);
  EXPECT_TRUE(is_utf8(page));
  EXPECT_FALSE(is_utf8(package.changes[1].before));
  EXPECT_THAT(page, HasSubstr("gr\xc3\xbc\xc3\x9f \xf0\x9f\x98\x80"));
  EXPECT_THAT(page, HasSubstr("caf\xef\xbf\xbd"));
  EXPECT_EQ(page.find('\0'), std::string::npos);
}

}  // namespace
}  // namespace tzc::rewriter
