// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/publisher_link.h>
#include <ros/subscription.h>
#include <ros/transport_publisher_link.h>
#include <tzc/channel.h>
#include <tzc/detail/codec.h>

#include <memory>
#include <mutex>

namespace tzc {

/// Where one publisher's shared messages enter a subscription of this process, under the name of the (parked)
/// TCPROS link that they replace: latching, statistics, connection headers and queues are roscpp's. Runs on
/// the channel's reader thread.
class Inlet {
 public:
  Inlet(const ros::SubscriptionPtr& subscription, ros::TransportPublisherLinkPtr link,
        detail::MessageCodec codec)
      : topic_(subscription->getName()),
        subscription_(subscription),
        link_(std::move(link)),
        codec_(std::move(codec)) {}

  void take(const channel::MessagePtr& message);

 private:
  void take_control_part(ros::Subscription& subscription, const channel::MessagePtr& message);
  void take_whole_message(ros::Subscription& subscription, const channel::MessagePtr& message);
  void give(ros::Subscription& subscription, const ros::SerializedMessage& message, bool ser, bool nocopy);
  bool take_directly(ros::Subscription& subscription, const channel::MessagePtr& message);
  /// The parked link's counters, which topic statistics and getBusStats tell. The poll thread, whose they
  /// are, has nothing to count while the link is parked.
  ros::PublisherLink::Stats& counted() const;
  boost::shared_ptr<void> decode(const channel::MessagePtr& message, bool copied) const;

  const std::string topic_;
  const ros::SubscriptionWPtr subscription_;
  const ros::TransportPublisherLinkPtr link_;
  const detail::MessageCodec codec_;
  bool tcpros_drained_ = false;  ///< reader thread
};

}  // namespace tzc
