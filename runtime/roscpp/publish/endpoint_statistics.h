// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/publication.h>
#include <ros/transport_subscriber_link.h>
#include <tzc/memory.h>
#include <tzc/options.h>

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "channel/inspection.h"
#include "statistics/page_layout.h"

namespace tzc {
namespace detail {

/// One subscriber of a publication, seen from its publisher.
struct LinkStatistics {
  std::string subscriber;
  statistics::Transport transport = statistics::Transport::tcpros;
  std::string reason;                     ///< why it is not on shared memory; empty when it is
  std::uint64_t messages = 0, bytes = 0;  ///< sent, as roscpp counts them
  std::uint64_t in_flight = 0, revoked = 0;
  channel::ConnectionInspection inspection;  ///< on shared memory
  std::uint32_t pid = 0;                     ///< 0: not known
};

/// What a publication has counted, and its subscribers.
struct EndpointStatistics {
  std::string topic, type;
  PublisherStatistics counters;
  MemoryStats memory;
  std::vector<LinkStatistics> links;
  bool has_links = false;  ///< false: another thread used the links, so they could not be read now
};

/// For people: why a subscriber on TCPROS is not on shared memory.
using WhyNot = std::function<std::string(const boost::weak_ptr<ros::TransportSubscriberLink>&)>;

/// The publication's subscribers. False: another thread publishes now, so nothing was read; this never waits for it.
bool read_links(ros::Publication& publication, const WhyNot& why_not, std::vector<LinkStatistics>& links);

}  // namespace detail
}  // namespace tzc
