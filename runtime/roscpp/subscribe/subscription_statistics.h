// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

#include "channel/inspection.h"
#include "statistics/page_layout.h"

namespace tzc {
namespace detail {

/// One publisher of a topic of this process's subscriptions.
struct SubscriptionStatistics {
  std::string topic, publisher;
  statistics::Transport transport = statistics::Transport::tcpros;
  std::uint64_t messages = 0, lost = 0, bytes = 0;
  std::uint64_t held_messages = 0, held_bytes = 0;
  channel::SubscriberInspection inspection;  ///< on shared memory
  std::uint32_t pid = 0;                     ///< 0: not known
};

}  // namespace detail
}  // namespace tzc
