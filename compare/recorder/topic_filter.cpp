// SPDX-License-Identifier: BSD-3-Clause
#include "recorder/topic_filter.h"

#include <algorithm>

namespace tzc::compare {
namespace {

bool matches(const std::vector<std::regex>& expressions, const std::string& topic) {
  return std::any_of(expressions.begin(), expressions.end(),
                     [&](const std::regex& expression) { return std::regex_match(topic, expression); });
}

}  // namespace

TopicFilter::TopicFilter(const std::vector<std::string>& topics, const std::vector<std::string>& excluded)
    : named_(topics), topics_(topics.begin(), topics.end()), excluded_(excluded.begin(), excluded.end()) {}

bool TopicFilter::accepts(const std::string& topic) const {
  if (is_infrastructure(topic)) return false;
  if (std::find(named_.begin(), named_.end(), topic) != named_.end()) return true;
  return (topics_.empty() || matches(topics_, topic)) && !matches(excluded_, topic);
}

bool TopicFilter::is_infrastructure(const std::string& topic) {
  return topic == "/rosout" || topic == "/rosout_agg" || topic == "/clock" || topic == "/statistics";
}

}  // namespace tzc::compare
