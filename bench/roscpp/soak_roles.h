// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstdint>
#include <vector>

namespace tzc {
namespace bench {

/// What the processes of one role did, in memory that they share with the process that watches them.
struct SoakCounts {
  std::atomic<std::uint64_t> published{0};
  std::atomic<std::uint64_t> received{0};
  std::atomic<std::uint64_t> spoiled{0};  ///< messages whose content was not what was published
};

/// What befalls a process while the others go on.
enum class Fate {
  lasts,    ///< nothing; it is watched
  stopped,  ///< SIGSTOP and SIGCONT in turns; it is watched
  killed,   ///< SIGKILL, and another takes its place
};

/// One process of a soak: a node that publishes or subscribes to topics of mixed sizes for hours.
struct SoakRole {
  const char* name;
  Fate fate;
  void (*run)(SoakCounts&);  ///< in a process of its own that has a ROS master; returns when ROS ends
  bool is_control = false;   ///< has nothing of TZC: what grows in it too is roscpp's
};

const std::vector<SoakRole>& soak_roles();

}  // namespace bench
}  // namespace tzc
