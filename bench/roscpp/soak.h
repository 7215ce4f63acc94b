// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sys/types.h>

#include <vector>

#include "process_needs.h"
#include "roscpp/soak_roles.h"

namespace tzc {
namespace bench {

struct SoakPlan {
  double minutes = 60;
  double look_every_s = 30;
  double kill_every_s = 20;
  double stop_for_s = 3;  ///< and as long until the next time
};

/// One role's process, and what was seen of it.
struct SoakProcess {
  const SoakRole* role;
  SoakCounts* counts;
  pid_t pid = -1;
  std::size_t killed = 0;
  std::vector<Needs> looks{};

  bool watched() const { return role->fate != Fate::killed; }
};

/// Starts a process for each role, lets it suffer what its role is for, and looks at it. They end with this object. For a
/// process that has a ROS master and one thread. The constructor throws as in_child does.
class Soak {
 public:
  explicit Soak(const SoakPlan& plan);
  ~Soak();
  Soak(const Soak&) = delete;
  Soak& operator=(const Soak&) = delete;

  /// Until the time is over or an interruption comes (hold_interrupts). False: a process ended by itself or could not be
  /// replaced, which is said.
  bool run();
  const std::vector<SoakProcess>& processes() const { return processes_; }
  double seconds() const;

 private:
  bool lasts();
  bool ended_by_itself();  ///< one did; one that ROS's master ended is started anew
  void replace_those_to_be_killed();
  void stop_or_continue();
  void look_at_all();

  const SoakPlan plan_;
  const std::int64_t start_ns_;
  bool stopped_ = false;
  std::vector<SoakProcess> processes_;
};

}  // namespace bench
}  // namespace tzc
