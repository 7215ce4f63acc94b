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
  UpgradeResponder(Worker& clerk, PeerPool& peers) : clerk_(clerk), peers_(peers) {}

  /// Topics attached from here on can be offered. An existing subscription's publishers are asked for offers.
  void attach(const std::string& topic, const MessageCodec& codec);

  /// Answers a publisher's offer; runs on roscpp's XMLRPC thread, so the work is only begun here.
  void answer(XmlRpc::XmlRpcValue& params, XmlRpc::XmlRpcValue& result);

 private:
  using LinkPtr = ros::TransportPublisherLinkPtr;

  std::string reason_to_refuse(const Offer& offer);
  void accept(const Offer& offer, int looks_left);
  void connect(const Offer& offer);
  void connection_failed(const Offer& offer, const Error& error, bool is_foreign_uid);
  void forget(const LinkPtr& link);
  void ask_publishers(const std::string& topic);
  void ask(const LinkPtr& link, const std::string& topic, int tries);
  bool codec_for(const Offer& offer, ros::Subscription& subscription, MessageCodec& codec) const;
  bool connected(const LinkPtr& link) const;

  Worker& clerk_;
  PeerPool& peers_;
  mutable std::mutex mutex_;
  std::map<std::string, std::vector<MessageCodec>> topics_;
  std::map<LinkPtr, std::shared_ptr<channel::Subscriber>> channels_;
  std::set<std::string> foreign_uids_;  ///< tokens of offers from other users' processes
};

}  // namespace detail
}  // namespace tzc
