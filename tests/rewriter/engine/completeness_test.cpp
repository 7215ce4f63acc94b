// SPDX-License-Identifier: BSD-3-Clause
// The report is compared with the calls that a second, simpler analysis found.
#include "engine/completeness.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "report/sample.h"

namespace tzc::rewriter {
namespace {

using ::testing::HasSubstr;

/// The calls that the sample's sites are.
std::set<ApiCall> calls_of(const Report& report) {
  std::set<ApiCall> calls;
  for (const Site& site : report.sites) calls.insert({site.kind, site.where, site.message_type});
  return calls;
}

std::string verdict(const Report& report, const std::set<ApiCall>& calls) {
  const Expected<void> complete = check_complete(report, calls);
  return complete ? "complete" : to_string(complete.error());
}

TEST(Completeness, every_call_has_its_site) {
  const Report report = test::sample().report;
  EXPECT_EQ(verdict(report, calls_of(report)), "complete");
}
TEST(Completeness, the_type_may_be_unknown_at_the_call) {
  const Report report = test::sample().report;
  std::set<ApiCall> calls;
  for (const Site& site : report.sites) calls.insert({site.kind, site.where, ""});
  EXPECT_EQ(verdict(report, calls), "complete");
}
TEST(Completeness, a_call_that_the_report_misses_is_named) {
  Report report = test::sample().report;
  const std::set<ApiCall> calls = calls_of(report);
  report.sites.erase(report.sites.begin() + 1);
  EXPECT_THAT(verdict(report, calls),
              HasSubstr("src/camera.cpp:21:3: the report is wrong: this publish call"));
}
TEST(Completeness, a_site_of_another_kind_does_not_count) {
  Report report = test::sample().report;
  const std::set<ApiCall> calls = calls_of(report);
  report.sites[1].kind = SiteKind::advertise;
  EXPECT_THAT(verdict(report, calls), HasSubstr("src/camera.cpp:21:3"));
}
TEST(Completeness, an_instance_of_a_template_that_the_report_misses_is_named) {
  const Report report = test::sample().report;
  std::set<ApiCall> calls = calls_of(report);
  calls.insert({SiteKind::publish, report.sites[1].where, "sensor_msgs/LaserScan"});
  EXPECT_THAT(verdict(report, calls), HasSubstr("0 times with sensor_msgs/LaserScan"));
}
TEST(Completeness, a_site_that_stands_twice_is_named) {
  Report report = test::sample().report;
  report.sites.push_back(report.sites[1]);
  EXPECT_THAT(verdict(report, calls_of(report)), HasSubstr("2 times with sensor_msgs/Image"));
}
TEST(Completeness, a_site_without_a_call_is_named) {
  const Report report = test::sample().report;
  std::set<ApiCall> calls = calls_of(report);
  calls.erase(calls.begin());
  EXPECT_THAT(verdict(report, calls), HasSubstr("but not in the package"));
}

}  // namespace
}  // namespace tzc::rewriter
