// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/receiver.h"

#include <ros/connection.h>
#include <ros/console.h>
#include <ros/this_node.h>
#include <ros/topic_manager.h>

#include <unistd.h>

#include <algorithm>

#include "posix/step.h"
#include "roscpp/configuration.h"
#include "roscpp/connection_name.h"
#include "roscpp/host_identity.h"
#include "roscpp/inlet.h"
#include "roscpp/patience.h"
#include "roscpp/roscpp_access.h"
#include "roscpp/xmlrpc_call.h"

namespace tzc {
namespace {

namespace access = roscpp_access;

/// The publisher's offer may come before roscpp knows the connection, so the link is looked for a few times.
constexpr int kLooks = 100;
constexpr std::chrono::milliseconds kLookAgain(5);

ros::SubscriptionPtr find_subscription(const std::string& topic) {
  ros::TopicManager& topics = *ros::TopicManager::instance();
  const boost::mutex::scoped_lock lock(access::subs_mutex_(topics));
  for (const ros::SubscriptionPtr& subscription : access::subscriptions_(topics))
    if (subscription->getName() == topic && !subscription->isDropped()) return subscription;
  return ros::SubscriptionPtr();
}

/// The TCPROS links of a subscription.
std::vector<ros::TransportPublisherLinkPtr> tcp_links(ros::Subscription& subscription) {
  std::vector<ros::TransportPublisherLinkPtr> links;
  const boost::mutex::scoped_lock lock(access::publisher_links_mutex_(subscription));
  for (const ros::PublisherLinkPtr& link : access::publisher_links_(subscription))
    if (const auto tcp = boost::dynamic_pointer_cast<ros::TransportPublisherLink>(link)) links.push_back(tcp);
  return links;
}

/// The link that the offer is about, not just any of that publisher: the one of an earlier subscription may
/// still be known there, and messages of both would come twice. Its TCPROS header may be on its way and must
/// not be looked at; it is there when the first record is taken (kSwitch waits for it).
ros::TransportPublisherLinkPtr find_link(ros::Subscription& subscription, const Offer& offer) {
  for (const ros::TransportPublisherLinkPtr& link : tcp_links(subscription)) {
    ros::Connection& connection = *link->getConnection();
    if (!connection.isDropped() && connection_name(connection, End::subscriber) == offer.connection)
      return link;
  }
  return ros::TransportPublisherLinkPtr();
}

}  // namespace

void Receiver::attach(const std::string& topic, const detail::MessageCodec& codec) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    std::vector<detail::MessageCodec>& codecs = topics_[topic];
    const bool known = std::any_of(codecs.begin(), codecs.end(), [&](const detail::MessageCodec& other) {
      return *other.type == *codec.type;
    });
    if (known) return;
    codecs.push_back(codec);
  }
  caller_.post([this, topic] { ask_publishers(topic); });
}

std::string Receiver::reason_to_refuse(const Offer& offer) {
  if (offer.identity != host_identity()) return "this node is on another machine or network namespace";
  const std::lock_guard<std::mutex> lock(mutex_);
  if (strangers_.erase(offer.token) != 0) return "the publisher is a process of another user";
  const auto found = topics_.find(offer.topic);
  if (found == topics_.end()) return "this node has not attached " + offer.topic;
  const bool fits =
      std::any_of(found->second.begin(), found->second.end(),
                  [&](const detail::MessageCodec& codec) { return codec.md5sum == offer.md5sum; });
  return fits ? std::string() : "this node expects another message type on " + offer.topic;
}

void Receiver::answer(XmlRpc::XmlRpcValue& params, XmlRpc::XmlRpcValue& result) {
  Offer offer;
  const std::string refusal = from_xmlrpc(params, offer) ? reason_to_refuse(offer)
                                                         : std::string("not an offer of this version of TZC");
  if (!refusal.empty()) {
    result = response(0, refusal);
    return;
  }
  caller_.post([this, offer] { accept(offer, kLooks); });
  result = response(1, "coming");
}

// When it stops looking, the publisher tries again.
void Receiver::accept(const Offer& offer, int looks_left) {
  const ros::SubscriptionPtr subscription = find_subscription(offer.topic);
  const LinkPtr link = subscription ? find_link(*subscription, offer) : LinkPtr();
  if (link) return connect(offer, subscription, link);
  if (looks_left > 0)
    caller_.post([this, offer, looks_left] { accept(offer, looks_left - 1); }, kLookAgain);
  else
    ROS_DEBUG_STREAM("TZC: " << offer.topic << " from " << offer.publisher << ": the offer is for connection "
                             << offer.connection << ", which is not there");
}

bool Receiver::connected(const LinkPtr& link) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return channels_.count(link) != 0;
}

bool Receiver::codec_for(const Offer& offer, ros::Subscription& subscription,
                         detail::MessageCodec& codec) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  bool found = false;
  for (const detail::MessageCodec& candidate : topics_.at(offer.topic)) {
    if (candidate.md5sum != offer.md5sum) continue;
    bool ser = false, is_wanted = false;
    subscription.getPublishTypes(ser, is_wanted, *candidate.type);
    if (!found || is_wanted) codec = candidate;
    found = true;
    if (is_wanted) break;
  }
  return found;
}

void Receiver::connect(const Offer& offer, const ros::SubscriptionPtr& subscription, const LinkPtr& link) {
  detail::MessageCodec codec;
  if (connected(link) || !codec_for(offer, *subscription, codec)) return;
  const auto inlet = std::make_shared<Inlet>(subscription, link, codec);
  const auto is_stranger = std::make_shared<bool>(false);
  channel::SubscriberOptions options;
  options.address = offer.address;
  options.hello = offer.token;
  options.on_message = [inlet](const channel::MessagePtr& message) { inlet->take(message); };
  options.on_disconnect = [this, link](const std::string&) { caller_.post([this, link] { forget(link); }); };
  options.authorize = [is_stranger](const channel::Credentials& peer) {
    *is_stranger = peer.uid != geteuid() && peer.uid != 0;  // root can read everything of this process anyway
    return !*is_stranger;
  };
  Expected<std::shared_ptr<channel::Subscriber>> channel = channel::Subscriber::create(std::move(options));
  if (!channel) return connection_failed(offer, channel.error(), *is_stranger);
  ROS_DEBUG_STREAM("TZC: " << offer.topic << " from " << offer.publisher << " comes through shared memory");
  const std::lock_guard<std::mutex> lock(mutex_);
  channels_[link] = *channel;
}

// The publisher will offer again, and give up when it is told that there is no sense in it.
void Receiver::connection_failed(const Offer& offer, const Error& error, bool is_stranger) {
  ROS_DEBUG_STREAM("TZC: " << offer.topic << " from " << offer.publisher
                           << " stays on TCPROS: " << error.text());
  const std::lock_guard<std::mutex> lock(mutex_);
  if (is_stranger) strangers_.insert(offer.token);
}

void Receiver::forget(const LinkPtr& link) {
  std::shared_ptr<channel::Subscriber> ended;
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto found = channels_.find(link);
  if (found == channels_.end()) return;
  ended = std::move(found->second);
  channels_.erase(found);
}

void Receiver::ask_publishers(const std::string& topic) {
  const ros::SubscriptionPtr subscription = find_subscription(topic);
  if (!subscription) return;
  for (const LinkPtr& link : tcp_links(*subscription)) ask(link, topic, 1);
}

// A publisher that does not know the question has no TZC, or will offer by itself once it has.
void Receiver::ask(const LinkPtr& link, const std::string& topic, int tries) {
  if (connected(link) || link->getConnection()->isDropped()) return;
  XmlRpc::XmlRpcValue params;
  params[0] = kProtocolVersion;
  params[1] = topic;
  params[2] = ros::this_node::getName();
  posix::step("request: calls");
  const XmlRpcReply reply = call_node(link->getPublisherXMLRPCURI(), kRequestMethod, params, kCallTimeout);
  if (reply.answered || reply.unknown) return;
  ROS_DEBUG_STREAM("TZC: " << topic << ", try " << tries << ": " << reply.status);
  const boost::weak_ptr<ros::TransportPublisherLink> weak = link;
  const auto again = [this, weak, topic, tries] {
    if (const LinkPtr waiting = weak.lock()) ask(waiting, topic, tries + 1);
  };
  if (tries < most_tries())
    caller_.post(again, pause_after(tries));
  else
    ROS_WARN_STREAM_THROTTLE(10, "TZC: " << topic << " stays on TCPROS after " << tries
                                         << " tries: " << reply.status
                                         << "; does the publisher run, and does this address lead to it "
                                            "(ROS_IP, ROS_HOSTNAME)?");
  posix::step("request: waits");
}

}  // namespace tzc
