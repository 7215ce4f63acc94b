// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

namespace tzc::monitor {

/// Joins the traces of several processes (docs/traces.md) into one JSON array, a line for each event. A line that is no
/// event, as the last one of a process that was killed, is left out.
class TraceJoin {
 public:
  explicit TraceJoin(std::ostream& joined) : joined_(joined) {}

  /// False: reading it failed, perhaps after some of its events.
  bool add(std::istream& trace, const std::string& name);
  /// Writes the end. False: no file had an event.
  bool finish();
  /// What was left out, and which files have no event.
  const std::vector<std::string>& troubles() const { return troubles_; }

 private:
  bool add_event(std::string line);

  std::ostream& joined_;
  bool has_events_ = false;
  std::vector<std::string> troubles_;
};

}  // namespace tzc::monitor
