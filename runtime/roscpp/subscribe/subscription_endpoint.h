// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/connection.h>
#include <ros/publisher_link.h>
#include <ros/subscription.h>
#include <ros/transport_publisher_link.h>
#include <tzc/channel.h>
#include <tzc/detail/codec.h>

#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include "roscpp/hold_limit.h"
#include "roscpp/subscribe/direct_call.h"
#include "roscpp/subscribe/tcpros_drain.h"

namespace tzc {
namespace detail {

/// Passes one publisher's shared messages to a subscription of this process, under the name of the parked
/// TCPROS link: latching, statistics, connection headers and queues stay roscpp's. Runs on one thread: the one
/// that reads for all subscriptions of the process, which must not wait, or one of its own, which may call callbacks.
class SubscriptionEndpoint {
 public:
  /// @param connection of the link, on which it was upgraded; roscpp may give it another one later
  SubscriptionEndpoint(const ros::SubscriptionPtr& subscription, ros::TransportPublisherLinkPtr link,
                       ros::ConnectionPtr connection, MessageCodec codec)
      : topic_(subscription->getName()),
        subscription_(subscription),
        link_(std::move(link)),
        connection_(std::move(connection)),
        codec_(std::move(codec)),
        calls_directly_(has_direct_callback(*subscription)) {}

  /// Whether the subscription had a direct callback when it was connected: it needs a thread of its own. A direct
  /// callback that is added later is called on the thread that does so for messages over TCPROS.
  bool calls_directly() const { return calls_directly_; }
  /// Messages that arrived over TCPROS come before any record.
  bool may_begin();
  void take(const channel::MessagePtr& message);
  /// Any thread.
  const HoldLimit& limit() const { return limit_; }

 private:
  void take_switch(const channel::Message& message);
  /// Empty, with a warning: the message is too large for it.
  ros::SerializedMessage in_wire_format(const boost::shared_ptr<void>& decoded) const;
  void take_control_part(ros::Subscription& subscription, const channel::MessagePtr& message);
  void take_whole_message(ros::Subscription& subscription, const channel::MessagePtr& message);
  void give(ros::Subscription& subscription, const ros::SerializedMessage& message, bool ser, bool nocopy);
  void take_indirectly(ros::Subscription& subscription, const channel::MessagePtr& message);
  bool take_directly(ros::Subscription& subscription, const channel::MessagePtr& message);
  bool take_as_guest(ros::Subscription& subscription, const channel::MessagePtr& message);
  DirectMessage described() const;
  /// Adds to the parked link's counters, which topic statistics and getBusStats show. The poll thread, which
  /// owns them, counts nothing while the link is parked.
  ros::PublisherLink::Stats& counted() const;
  /// For a callback that may write, or a subscription that holds too much of the publisher's memory.
  bool must_copy(const channel::Message& message, bool may_write) const;
  /// A view of the message, or a copy.
  boost::shared_ptr<void> decode(const channel::MessagePtr& message, bool copied) const;
  bool may_hold(const channel::Message& message) const;
  std::shared_ptr<const void> hold(const channel::MessagePtr& message) const;

  const std::string topic_;
  const ros::SubscriptionWPtr subscription_;
  const ros::TransportPublisherLinkPtr link_;
  const ros::ConnectionPtr connection_;
  const MessageCodec codec_;
  const bool calls_directly_;
  TcprosDrain tcpros_;           ///< reader thread
  bool tcpros_drained_ = false;  ///< reader thread
  HoldLimit limit_;
};

}  // namespace detail
}  // namespace tzc
