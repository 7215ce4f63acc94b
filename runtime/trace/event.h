// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace tzc {
namespace trace {

/// What a thread does with a message; in this order in time.
enum class Step : std::uint8_t {
  roscpp_publish,  ///< roscpp's own publish, which TCPROS subscribers need
  publish,         ///< the publisher sends it to one subscriber
  wake,            ///< the subscriber's thread has woken up, until it looks at the message
  take,            ///< the subscriber wins the message and maps its blocks
  callback,        ///< a callback of the subscriber
};

/// The part of a step in its message's flow: the arrow from publish to callback.
enum class Arrow : std::uint8_t { none, begins, passes, ends };

/// One step of one message on one thread.
struct Event {
  std::uint64_t begin_ns;  ///< CLOCK_MONOTONIC, as all processes of a machine see it
  std::uint64_t end_ns;
  std::uint64_t message;  ///< what both ends call it; 0: nothing that the other end knows
  std::uint64_t bytes;    ///< sent or received besides what lies in shared memory; 0: not known
  const char* topic;      ///< of keep()
  std::uint32_t thread;
  Step step;
  Arrow arrow;
};

}  // namespace trace
}  // namespace tzc
