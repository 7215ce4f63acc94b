// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/subscription.h>
#include <ros/transport_publisher_link.h>
#include <tzc/channel.h>
#include <tzc/detail/codec.h>
#include <xmlrpcpp/XmlRpc.h>

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "roscpp/subscribe/subscription_endpoint.h"
#include "roscpp/subscribe/subscription_statistics.h"
#include "roscpp/upgrade/offer.h"
#include "roscpp/upgrade/peer_pool.h"
#include "roscpp/worker.h"

namespace tzc {
namespace detail {

/// The subscribing side of this process: which topics may use shared memory, and their channels. Thread-safe.
class UpgradeResponder {
 public:
  /// @param clerk runs jobs that never wait
  /// @param peers runs calls to publishers, which wait
  /// @param on_offer called on the clerk's thread when a publisher has offered
  UpgradeResponder(Worker& clerk, PeerPool& peers, std::function<void()> on_offer)
      : clerk_(clerk), peers_(peers), on_offer_(std::move(on_offer)) {}

  /// Topics attached from here on can be offered. An existing subscription's publishers are asked for offers; `ask`: also those of a topic
  /// that is attached already.
  void attach(const std::string& topic, const MessageCodec& codec, bool ask);

  /// Answers a publisher's offer; runs on roscpp's XMLRPC thread, so the work is only begun here.
  void answer(XmlRpc::XmlRpcValue& params, XmlRpc::XmlRpcValue& result);

  /// Gives the publishers of all attached topics, whether they are on shared memory or on TCPROS. False: it gave none or some of them, since
  /// roscpp has its list of subscriptions locked, maybe for as long as the master is away.
  bool look(std::vector<SubscriptionStatistics>& all) const;

 private:
  using LinkPtr = ros::TransportPublisherLinkPtr;
  struct Channel {
    std::shared_ptr<channel::Subscriber> subscriber;
    std::shared_ptr<const SubscriptionEndpoint> endpoint;
  };
  using Channels = std::map<LinkPtr, Channel>;

  std::string reason_to_refuse(const Offer& offer);
  void accept(const Offer& offer, int looks_left);
  void connect(const Offer& offer);
  channel::SubscriberOptions options_for(const Offer& offer, const LinkPtr& link,
                                         const std::shared_ptr<SubscriptionEndpoint>& endpoint,
                                         const std::shared_ptr<bool>& is_foreign_uid);
  void connection_failed(const Offer& offer, const Error& error, bool is_foreign_uid);
  void forget(const LinkPtr& link);
  void ask_publishers(const std::string& topic);
  void ask(const LinkPtr& link, const std::string& topic, int tries);
  bool codec_for(const Offer& offer, ros::Subscription& subscription, MessageCodec& codec) const;
  bool connected(const LinkPtr& link) const;

  Worker& clerk_;
  PeerPool& peers_;
  const std::function<void()> on_offer_;
  mutable std::mutex mutex_;
  std::map<std::string, std::vector<MessageCodec>> topics_;
  Channels channels_;
  std::set<std::string> foreign_uids_;  ///< tokens of offers from other users' processes
};

}  // namespace detail
}  // namespace tzc
