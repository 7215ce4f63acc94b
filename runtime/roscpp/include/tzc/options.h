// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tzc/memory.h>
#include <tzc/policy.h>

#include <cstddef>
#include <cstdint>

namespace tzc {

/// What publish() does with a message for which no shared memory is left.
enum class OnExhausted {
  deliver,  ///< sends it serialized through the socket: slower, but nothing is lost
  drop,     ///< drops and counts it
};

/// Options of one publisher. ROS parameters and the environment override them (docs/configuration.md).
struct PublisherOptions {
  std::size_t memory_size = 0;  ///< bytes of shared memory; 0: sized by queue and first message, grows
  Policy policy;
  OnExhausted on_exhausted = OnExhausted::deliver;
  Prefault prefault = Prefault::on_first_use;
};

/// Counters of all publishers of one topic in this process, since the topic was advertised.
struct PublisherStatistics {
  std::uint64_t messages = 0;    ///< messages that became a control part, however many subscribers got it
  std::uint64_t shared = 0;      ///< messages sent as a control part, per subscriber
  std::uint64_t serialized = 0;  ///< messages sent whole, per subscriber
  std::uint64_t copied_bytes =
      0;  ///< bytes of data parts that were copied into shared memory: they lay elsewhere when they
          ///< were published, or were written again while subscribers had them
  std::uint64_t exhausted = 0;  ///< messages for which no shared memory was left
  std::uint64_t dropped = 0;    ///< messages dropped by OnExhausted::drop
  std::uint64_t revoked = 0;  ///< messages sent and taken back unread, per subscriber: its queue was full, or
                              ///< best_effort needed their memory, or it left
  std::uint64_t control_bytes = 0;     ///< bytes of control parts, per message
  std::size_t shared_subscribers = 0;  ///< subscribers on shared memory now
};

}  // namespace tzc
