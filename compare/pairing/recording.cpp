// SPDX-License-Identifier: BSD-3-Clause
#include "pairing/recording.h"

#include <regex>
#include <string_view>

namespace tzc::compare {

std::uint64_t digest_of(const Bytes& message) {
  return std::hash<std::string_view>()({reinterpret_cast<const char*>(message.data()), message.size()});
}

std::string without_anonymous_part(const std::string& node) {
  // roscpp appends nanoseconds, rospy and roslaunch the process id and milliseconds.
  static const std::regex anonymous("(_[^/_]+)?_(\\d+_)?\\d{12,}$");
  static const std::regex digits("_(\\d+_)?\\d{12,}$");
  return std::regex_search(node, anonymous) ? std::regex_replace(node, digits, "_*") : node;
}

}  // namespace tzc::compare
