// SPDX-License-Identifier: BSD-3-Clause
#include "words.h"

#include <fmt/format.h>

#include <string_view>

namespace tzc::monitor {
namespace {

struct Advice {
  const char* part;  ///< of the reason
  const char* text;
};

constexpr Advice advices[] = {
    {"does not know the method tzcOffer",
     "That node does not use TZC: port it, or start it with tzc-run (rospy nodes stay on TCPROS)."},
    {"has not attached",
     "It subscribes by nh.subscribe: use tzc::subscribe or tzc::attach there. Or TZC is switched off there: "
     "rosparam get NODE/tzc, TZC_DISABLE."},
    {"disable_topics names this topic",
     "Take the topic from that parameter, or from TZC_DISABLE_TOPICS, to share it."},
    {"another machine or network namespace", "Containers need --network=host to share memory."},
    {"another user", "Run both nodes as the same user, also inside containers."},
    {"not an offer of this version", "Use one release of TZC for all nodes of the machine."},
    {"another message type", "The md5sums differ: build both nodes with the same message package."},
    {"file descriptors", "Raise the limit: ulimit -n before roslaunch, LimitNOFILE= in systemd."},
    {"does not say where that node is",
     "See rosnode info; rosnode cleanup removes what is left of dead nodes."},
    {"no answer from", "The node is stopped, or ROS_IP or ROS_HOSTNAME lead elsewhere."},
    {"cannot connect to", "ROS_IP or ROS_HOSTNAME of that node may lead elsewhere."},
    {"asked for UDPROS", "Subscribe without ros::TransportHints().unreliable()."},
};

}  // namespace

std::string short_bytes(double bytes) {
  const char* const units[] = {"", "K", "M", "G", "T"};
  std::size_t unit = 0;
  for (; bytes >= 1000 && unit + 1 < std::size(units); ++unit) bytes /= 1024;
  return fmt::format("{:.{}f}{}", bytes, unit == 0 || bytes >= 99.95 ? 0 : 1, units[unit]);
}

std::string short_time(double seconds) {
  if (seconds < 999.5e-6) return fmt::format("{:.0f} us", seconds * 1e6);
  if (seconds < 9.95e-3) return fmt::format("{:.1f} ms", seconds * 1e3);
  if (seconds < 0.9995) return fmt::format("{:.0f} ms", seconds * 1e3);
  return fmt::format("{:.{}f} s", seconds, seconds < 9.95 ? 1 : 0);
}

const char* name(State state) {
  switch (state) {
    case State::running:
      return "running";
    case State::stopped:
      return "stopped";
    case State::silent:
      return "silent";
  }
  return "unknown";
}

const char* name(Transport transport) {
  switch (transport) {
    case Transport::shared:
      return "shared";
    case Transport::tcpros:
      return "TCPROS";
    case Transport::udpros:
      return "UDPROS";
    case Transport::intraprocess:
      return "in process";
    case Transport::unknown:
      return "unknown";
  }
  return "unknown";
}

std::string named_reason(const Connection& connection) {
  constexpr std::string_view itself = "this node ";
  const bool is_own = connection.reason.rfind(itself, 0) == 0;
  const std::string text =
      is_own ? connection.subscriber + " " + connection.reason.substr(itself.size()) : connection.reason;
  return text.empty() || text.back() != '?' ? text + "." : text;
}

std::string advice(const std::string& reason) {
  for (const Advice& one : advices)
    if (reason.find(one.part) != std::string::npos) return one.text;
  return "";
}

}  // namespace tzc::monitor
