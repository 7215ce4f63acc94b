// SPDX-License-Identifier: BSD-3-Clause
#include "join_trace.h"

#include <fmt/format.h>

#include <istream>
#include <nlohmann/json.hpp>
#include <ostream>

namespace tzc::monitor {

bool TraceJoin::add_event(std::string line) {
  if (!line.empty() && line.back() == ',') line.pop_back();
  if (line.empty() || line.front() != '{' || !nlohmann::json::accept(line)) return false;
  joined_ << (has_events_ ? ",\n" : "[\n") << line;
  has_events_ = true;
  return true;
}

bool TraceJoin::add(std::istream& trace, const std::string& name) {
  std::size_t events = 0, others = 0;
  for (std::string line; std::getline(trace, line);) {
    if (line.empty() || line == "[" || line == "]") continue;
    ++(add_event(std::move(line)) ? events : others);
  }
  if (trace.bad()) {
    troubles_.push_back(fmt::format("{} cannot be read", name));
    return false;
  }
  if (events == 0) troubles_.push_back(fmt::format("{} has no event of a trace", name));
  if (events > 0 && others > 0)
    troubles_.push_back(
        fmt::format("{}: {} lines are no events and are left out (was its process killed?)", name, others));
  return true;
}

bool TraceJoin::finish() {
  if (has_events_) joined_ << "\n]\n";
  return has_events_;
}

}  // namespace tzc::monitor
