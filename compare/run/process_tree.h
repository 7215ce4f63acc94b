// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sys/types.h>

#include <map>
#include <string>
#include <vector>

namespace tzc::compare {

/// Live and dead (not yet waited for) children of a process.
std::vector<pid_t> children_of(pid_t parent);

/// Sums up the processor time of processes and of all that they start, by the node's name (__name:=, without what makes
/// anonymous names others in each run) or the program's. roslaunch, rosrun, what these use, and shells are not counted.
class CpuMeter {
 public:
  /// Looks at these processes and their descendants. Call it often: what a process has used since the last
  /// look is lost when it ends.
  void sample(const std::vector<pid_t>& roots);
  /// Since each process began, by name.
  std::map<std::string, double> seconds() const;

 private:
  struct Usage {
    std::string name;
    unsigned long long ticks = 0;
  };
  void visit(pid_t pid, const std::map<pid_t, std::vector<pid_t>>& children);

  std::map<pid_t, Usage> usage_;
};

}  // namespace tzc::compare
