// SPDX-License-Identifier: BSD-3-Clause
// Commands as builds write them: launchers in front of the compiler, options that Clang does not know.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "edits/files.h"
#include "golden/case.h"
#include "report/output.h"

namespace tzc::rewriter {
namespace {

constexpr const char* node =
    "#include <ros/ros.h>\n#include <sensor_msgs/Image.h>\nvoid run(ros::NodeHandle& nh) {\n"
    "  ros::Publisher pub = nh.advertise<sensor_msgs::Image>(\"image\", 10);\n  sensor_msgs::Image image;\n"
    "  image.data.resize(10);\n  pub.publish(image);\n}\n";

/// What becomes of a package whose commands begin like this instead of with "c++".
Expected<PortPlan> planned(const std::string& command, const std::string& source = node) {
  const test::Package package({{"src/node.cpp", source}});
  const std::string file = package.dir() + "/build/compile_commands.json";
  std::string text = *read_file(file);
  const std::string begin = "\"command\":\"c++ ";
  text.replace(text.find(begin), begin.size(), "\"command\":\"" + command + " ");
  if (!write_file(file, text)) return Error{"cannot be written", file, ""};
  return plan_port(package.options({}));
}

std::string level_of(const Expected<PortPlan>& plan) {
  if (!plan) return to_string(plan.error());
  std::string levels;
  for (const Site& site : plan->report.sites)
    if (site.kind == SiteKind::publish) levels += name_of(site.level);
  return levels;
}

class Command : public testing::TestWithParam<const char*> {};

TEST_P(Command, is_understood) {
  EXPECT_EQ(level_of(planned(GetParam())), "zero_copy");
}

INSTANTIATE_TEST_SUITE_P(Launchers, Command,
                         testing::Values("c++", "/usr/bin/c++", "ccache c++",
                                         "/usr/bin/ccache arm-linux-gnueabihf-g++-12",
                                         "cmake -E env CCACHE_DIR=/c ccache /usr/bin/c++",
                                         "cmake -E env CC=/usr/bin/cc ccache g++",
                                         "my-launcher --verbose=no clang++-19"));
INSTANTIATE_TEST_SUITE_P(OptionsOfGcc, Command,
                         testing::Values("c++ -fext-numeric-literals", "c++ -fconcepts",
                                         "c++ -ftree-parallelize-loops=4",
                                         "c++ -fopt-info-vec -fno-var-tracking-assignments -mno-such-thing",
                                         "c++ -flto-partition=none"));

TEST(Commands, an_error_beside_an_option_of_gcc_is_an_error) {
  EXPECT_THAT(
      level_of(planned("c++ -fext-numeric-literals", std::string(node) + "int f() { return g(); }\n")),
      testing::HasSubstr("undeclared identifier 'g'"));
}

}  // namespace
}  // namespace tzc::rewriter
