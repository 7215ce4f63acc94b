// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/subscription.h>
#include <ros/transport_publisher_link.h>
#include <tzc/channel.h>
#include <tzc/detail/codec.h>
#include <xmlrpcpp/XmlRpc.h>

#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <vector>

#include "roscpp/offer.h"
#include "roscpp/worker.h"

namespace tzc {

/// The subscribing side of this process: which topics may come through shared memory, and the channels
/// through which they do. Thread-safe.
class Receiver {
 public:
  /// @param caller calls publishers, and waits for them
  explicit Receiver(Worker& caller) : caller_(caller) {}

  /// Topics attached from here on can be offered. An existing subscription's publishers are asked for offers.
  void attach(const std::string& topic, const detail::MessageCodec& codec);

  /// Answers a publisher's offer; runs on roscpp's XMLRPC thread, so the work is only begun here.
  void answer(XmlRpc::XmlRpcValue& params, XmlRpc::XmlRpcValue& result);

 private:
  using LinkPtr = ros::TransportPublisherLinkPtr;

  std::string reason_to_refuse(const Offer& offer);
  void accept(const Offer& offer, int looks_left);
  void connect(const Offer& offer, const ros::SubscriptionPtr& subscription, const LinkPtr& link);
  void connection_failed(const Offer& offer, const Error& error, bool is_stranger);
  void forget(const LinkPtr& link);
  void ask_publishers(const std::string& topic);
  void ask(const LinkPtr& link, const std::string& topic, int tries);
  bool codec_for(const Offer& offer, ros::Subscription& subscription, detail::MessageCodec& codec) const;
  bool connected(const LinkPtr& link) const;

  Worker& caller_;
  mutable std::mutex mutex_;
  std::map<std::string, std::vector<detail::MessageCodec>> topics_;
  std::map<LinkPtr, std::shared_ptr<channel::Subscriber>> channels_;
  std::set<std::string> strangers_;  ///< tokens of offers from other users' processes
};

}  // namespace tzc
