// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/subscribe/write_warning.h"

#include <ros/console.h>

#include <mutex>
#include <set>

namespace tzc {
namespace detail {

void warn_of_write(const std::string& topic) {
  static std::mutex mutex;
  static auto* const warned = new std::set<std::string>;  // outlives every subscriber
  const std::lock_guard<std::mutex> lock(mutex);
  if (!warned->insert(topic).second) return;
  ROS_WARN_STREAM(
      "TZC: "
      << topic << ": this node writes to messages that it received by const pointer or reference "
      << "(a const_cast, or drawing on toCvShare(...)->image). It changes pages of its own, which "
      << "no other node sees, at the cost of page faults; take a copy (toCvCopy, a callback with a "
      << "non-const pointer) instead (share/doc/tzc/troubleshooting.md). This is said once for each topic");
}

void warn_of_copies(const std::string& topic) {
  static std::once_flag warned;
  std::call_once(warned, [&topic] {
    ROS_WARN_STREAM(
        "TZC: " << topic << ": this system refuses what a subscriber needs to write to received messages "
                << "(mprotect or madvise, in a sandbox), so each message is copied when it is received. "
                << "_tzc/private_writes:=0 avoids the copies in a node that does not write "
                << "(share/doc/tzc/configuration.md)");
  });
}

}  // namespace detail
}  // namespace tzc
