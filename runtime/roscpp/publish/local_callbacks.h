// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/publication.h>
#include <tzc/detail/attachment.h>
#include <tzc/detail/codec.h>
#include <tzc/message.h>

#include <atomic>
#include <cstdint>
#include <string>

#include "roscpp/hold_limit.h"
#include "roscpp/upgrade/peer_pool.h"

namespace tzc {
namespace detail {

/// The callbacks of the publisher's own process, which roscpp passes a message to by pointer. Thread-safe.
class LocalCallbacks {
 public:
  /// @param most_bytes that all of them together may hold of the topic's memory (HoldLimit)
  /// @param peers waits for roscpp's poll thread
  LocalCallbacks(std::uint64_t most_bytes, PeerPool& peers) : peers_(peers) {
    limit_.set_most_bytes(most_bytes);
  }

  /// What they may see of a message of type `codec.type`; those that may have a view of it are made ready for faults
  /// (fault_ready_queue.h). Call it before each such message. Takes subscriber_links_mutex_ and the subscriptions' callbacks_mutex_,
  /// briefly.
  LocalMessage prepare(ros::Publication& publication, const MessageCodec& codec,
                       const message::Encoded& encoded) const;

 private:
  bool may_hold(const std::string& topic, std::uint64_t bytes) const;
  void keep_others_ready() const;

  HoldLimit limit_;
  PeerPool& peers_;
  mutable std::atomic<bool> others_are_kept_ready_{false};
};

}  // namespace detail
}  // namespace tzc
