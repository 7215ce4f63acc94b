// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <regex>
#include <string>
#include <vector>

namespace tzc::compare {

/// Which topics are recorded.
class TopicFilter {
 public:
  /// @param topics, excluded regular expressions; no topics: all. A topic that is named outright is never
  /// excluded.
  /// @throws std::regex_error
  TopicFilter(const std::vector<std::string>& topics, const std::vector<std::string>& excluded);

  bool accepts(const std::string& topic) const;
  /// ROS's own topics, which are never recorded.
  static bool is_infrastructure(const std::string& topic);

 private:
  std::vector<std::string> named_;
  std::vector<std::regex> topics_, excluded_;
};

}  // namespace tzc::compare
