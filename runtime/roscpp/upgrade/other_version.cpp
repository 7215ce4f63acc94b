// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/upgrade/other_version.h"

#include <ros/console.h>

namespace tzc {
namespace detail {

bool ToldPeers::is_new(const std::string& peer) {
  const std::lock_guard<std::mutex> lock(mutex_);
  return peers_.size() < limit_ && peers_.insert(peer).second;
}

void warn_of_other_version(const std::string& peer, const std::string& topic) {
  static auto* const told = new ToldPeers(100);  // outlives every thread that may still warn
  if (told->is_new(peer))
    ROS_WARN_STREAM(
        "TZC: "
        << peer << " runs another version of TZC: " << topic
        << " and every other topic between it and this node stay on TCPROS. Messages arrive, but "
           "serialized; build both nodes with one version to share memory (share/doc/tzc/versions.md)");
}

}  // namespace detail
}  // namespace tzc
