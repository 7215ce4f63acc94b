// SPDX-License-Identifier: BSD-3-Clause
/// tzc-diagnostics: a ROS node that publishes on /diagnostics what tzc-monitor shows (docs/tzc-monitor.md).
///
///   /proc/PID/fd -> take_sample -> add_rates -> statuses -> /diagnostics
#include <ros/ros.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <optional>
#include <string>
#include <vector>

#include "diagnostics/status.h"
#include "processes.h"
#include "rates.h"

namespace tzc::monitor {
namespace {

constexpr double longest_period_s = 3600;

std::string host_name() {
  char name[256] = {};
  return ::gethostname(name, sizeof name - 1) == 0 ? name : "";
}

class Diagnostics {
 public:
  explicit Diagnostics(ros::NodeHandle& node)
      : publisher_(node.advertise<diagnostic_msgs::DiagnosticArray>("/diagnostics", 1)) {}

  void publish() {
    Sample sample = take_sample();
    for (const std::string& trouble : sample.troubles)
      ROS_WARN_STREAM_THROTTLE(60, "tzc-diagnostics: " << trouble);
    add_rates(before_, sample.nodes);
    before_ = sample.nodes;
    diagnostic_msgs::DiagnosticArray array;
    array.header.stamp = ros::Time::now();
    array.status = statuses(sample.nodes, host_);
    publisher_.publish(array);
  }

 private:
  const std::string host_ = host_name();
  const ros::Publisher publisher_;
  std::vector<Node> before_;
};

const char* const help =
    "Usage: tzc-diagnostics [_period:=SECONDS] [REMAPPINGS]\n\n"
    "Publishes diagnostic_msgs/DiagnosticArray on /diagnostics: a status for each node of this machine that\n"
    "shares messages through TZC, from the pages that tzc-monitor reads. Watching costs the nodes nothing.\n"
    "\nOptions:\n"
    "  _period  seconds between two messages, 1 unless given, 0.1 to 3600\n"
    "  --help, --version\n"
    "\nExamples:\n"
    "  rosrun tzc tzc-diagnostics\n"
    "  rosrun tzc tzc-diagnostics _period:=5 /diagnostics:=/robot/diagnostics\n";

/// The exit status of an answer.
int say(const std::string& text) {
  if (std::fputs(text.c_str(), stdout) >= 0 && std::fflush(stdout) == 0) return 0;
  std::fprintf(stderr, "tzc-diagnostics: cannot write to standard output: %s\n", std::strerror(errno));
  return 2;
}

/// The exit status of what is answered without a ROS master, whose own arguments do not begin with a dash.
std::optional<int> answer(int argc, char** argv) {
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument.empty() || argument.front() != '-') continue;
    if (argument == "--help" || argument == "-h") return say(help);
    if (argument == "--version") return say("tzc-diagnostics " TZC_VERSION "\n");
    std::fprintf(stderr, "tzc-diagnostics: unknown option %s; --help shows what there is\n", argv[i]);
    return 2;
  }
  return std::nullopt;
}

/// Seconds between two messages. None: it is no such number, which has been said.
std::optional<double> period() {
  const ros::NodeHandle options("~");
  double seconds = 1;
  const bool is_number = !options.hasParam("period") || options.getParam("period", seconds);
  if (is_number && seconds >= 0.1 && seconds <= longest_period_s) return seconds;
  std::fprintf(stderr, "tzc-diagnostics: _period is a number of seconds from 0.1 to %.0f\n",
               longest_period_s);
  return {};
}

}  // namespace
}  // namespace tzc::monitor

int main(int argc, char** argv) {
  if (const auto status = tzc::monitor::answer(argc, argv)) return *status;
  ros::init(argc, argv, "tzc_diagnostics", ros::init_options::AnonymousName);
  ros::NodeHandle node;
  tzc::monitor::Diagnostics diagnostics(node);
  const std::optional<double> period = tzc::monitor::period();
  if (!period) return 2;
  const ros::WallTimer timer = node.createWallTimer(
      ros::WallDuration(*period), [&](const ros::WallTimerEvent&) { diagnostics.publish(); });
  ros::spin();
}
