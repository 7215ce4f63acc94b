// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/upgrade/upgrade_responder.h"

#include <ros/connection.h>

#include <ros/this_node.h>
#include <ros/topic_manager.h>

#include <unistd.h>

#include <algorithm>

#include "channel/end_reason.h"
#include "roscpp/configuration.h"
#include "roscpp/descriptor_budget.h"
#include "roscpp/roscpp_access.h"
#include "roscpp/subscribe/fault_ready_queue.h"
#include "roscpp/subscribe/write_warning.h"
#include "roscpp/throttled_warning.h"
#include "roscpp/upgrade/connection_name.h"
#include "roscpp/upgrade/host_identity.h"
#include "roscpp/upgrade/other_version.h"
#include "roscpp/upgrade/retry_policy.h"
#include "roscpp/upgrade/xmlrpc_call.h"
#include "sync_point/sync_point.h"
#include "trace/trace.h"

namespace tzc {
namespace detail {
namespace {

namespace access = roscpp_access;

/// The offer may arrive before roscpp knows the connection, so the link is searched for a few times.
constexpr int kLooks = 100;
constexpr std::chrono::milliseconds kLookAgain(5);

/// roscpp keeps its list of subscriptions locked while it asks the master about one of them, and asks for as long as the master is away.
constexpr std::chrono::milliseconds kLookAgainWhenBusy(100);

/// In the pool of peers: waits for this process alone.
constexpr char kNoPeer[] = "";

struct Search {
  bool is_busy;  ///< roscpp has the list locked: look again later
  ros::SubscriptionPtr found;
};

Search find_subscription(const std::string& topic) {
  ros::TopicManager& topics = *ros::TopicManager::instance();
  const boost::mutex::scoped_try_lock lock(access::subs_mutex_(topics));
  if (!lock) return {true, nullptr};
  for (const ros::SubscriptionPtr& subscription : access::subscriptions_(topics))
    if (subscription->getName() == topic && !subscription->isDropped()) return {false, subscription};
  return {false, nullptr};
}

/// The TCPROS links of a subscription.
std::vector<ros::TransportPublisherLinkPtr> tcp_links(ros::Subscription& subscription) {
  std::vector<ros::TransportPublisherLinkPtr> links;
  const boost::mutex::scoped_lock lock(access::publisher_links_mutex_(subscription));
  for (const ros::PublisherLinkPtr& link : access::publisher_links_(subscription))
    if (const auto tcp = boost::dynamic_pointer_cast<ros::TransportPublisherLink>(link)) links.push_back(tcp);
  return links;
}

struct OfferedLink {
  ros::TransportPublisherLinkPtr link;
  ros::ConnectionPtr connection;
};

bool is_dropped(const ros::ConnectionPtr& connection) {
  return !connection || connection->isDropped();
}

/// The link of the offer's connection, not any link of that publisher: roscpp may still know the link of an
/// earlier subscription, and messages of both would arrive twice. Does not read the link's TCPROS header,
/// which may not have arrived; it has when the first record is taken (kSwitch waits for it).
OfferedLink find_link(ros::Subscription& subscription, const Offer& offer) {
  for (const ros::TransportPublisherLinkPtr& link : tcp_links(subscription)) {
    const ros::ConnectionPtr connection = connection_of(*link);
    if (!is_dropped(connection) && connection_name(*connection, End::subscriber) == offer.connection)
      return {link, connection};
  }
  return OfferedLink();
}

/// roscpp writes the name when it reads the connection's header, which comes before any message. Empty while it does.
std::string publisher_of(ros::TransportPublisherLink& link, std::uint64_t messages) {
  const ros::ConnectionPtr connection = messages == 0 ? connection_of(link) : nullptr;
  if (!connection) return link.getCallerID();
  const boost::unique_lock<boost::recursive_mutex> lock(access::read_mutex_(*connection), boost::try_to_lock);
  return lock.owns_lock() ? link.getCallerID() : std::string();
}

SubscriptionStatistics statistics_of(ros::TransportPublisherLink& link, const std::string& topic) {
  SubscriptionStatistics seen;
  seen.topic = topic;
  const ros::PublisherLink::Stats& stats = link.getStats();
  seen.messages = __atomic_load_n(&stats.messages_received_, __ATOMIC_ACQUIRE);  // another thread counts
  seen.bytes = __atomic_load_n(&stats.bytes_received_, __ATOMIC_RELAXED);
  seen.publisher = publisher_of(link, seen.messages);
  return seen;
}

void add_shared(const channel::Subscriber& subscriber, const HoldLimit& limit, SubscriptionStatistics& seen) {
  const channel::SubscriberStats stats = subscriber.stats();
  seen.transport = statistics::Transport::shared;
  seen.lost = stats.lost;
  seen.bytes = stats.bytes;
  seen.held_messages = limit.held_messages();
  seen.held_bytes = limit.held_bytes();
  seen.inspection = channel::inspect(subscriber);
  seen.pid = static_cast<std::uint32_t>(subscriber.peer().pid);
}

/// That the publisher has gone is nothing to tell of.
void warn_of_end(const ros::TransportPublisherLinkPtr& link, const std::string& topic,
                 const std::string& reason) {
  if (reason == channel::closed_by_publisher || is_dropped(connection_of(*link))) return;
  TZC_WARN_THROTTLED_FOR(
      topic + " from " + link->getCallerID(), 10,
      "TZC: " << topic << " from " << link->getCallerID() << " goes back to TCPROS: " << reason);
}

}  // namespace

void UpgradeResponder::attach(const std::string& topic, const MessageCodec& codec, bool ask) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    std::vector<MessageCodec>& codecs = topics_[topic];
    const bool known = std::any_of(codecs.begin(), codecs.end(),
                                   [&](const MessageCodec& other) { return *other.type == *codec.type; });
    if (known && !ask) return;
    if (!known) codecs.push_back(codec);
  }
  clerk_.post([this, topic] { ask_publishers(topic); });
}

std::string UpgradeResponder::reason_to_refuse(const Offer& offer) {
  if (offer.identity != host_identity()) return "this node is on another machine or network namespace";
  const std::lock_guard<std::mutex> lock(mutex_);
  if (foreign_uids_.erase(offer.token) != 0) return "the publisher is a process of another user";
  const auto found = topics_.find(offer.topic);
  if (found == topics_.end())
    return are_settings_read() && is_left_out(offer.topic)
               ? "the subscriber's ~tzc/disable_topics names this topic"
               : "this node has not attached " + offer.topic;
  const bool fits = std::any_of(found->second.begin(), found->second.end(),
                                [&](const MessageCodec& codec) { return codec.md5sum == offer.md5sum; });
  return fits ? std::string() : "this node expects another message type on " + offer.topic;
}

void UpgradeResponder::answer(XmlRpc::XmlRpcValue& params, XmlRpc::XmlRpcValue& result) {
  clerk_.post(on_offer_);
  Offer offer;
  if (is_other_version(params, offer)) warn_of_other_version(offer.publisher, offer.topic);
  if (!from_xmlrpc(params, offer)) {
    result = response(0, kOtherVersionStatus);
    return;
  }
  if (!has_spare_descriptors()) {  // asked first: a refusal is for ever, and host_identity() needs one
    result = response(1, "the subscriber: " + descriptor_advice());
    return;
  }
  const std::string refusal = reason_to_refuse(offer);
  if (!refusal.empty()) {
    result = response(0, refusal);
    return;
  }
  clerk_.post([this, offer] { accept(offer, kLooks); });
  result = response(1, kComingStatus);
}

// When the search ends without a link, the publisher tries again.
void UpgradeResponder::accept(const Offer& offer, int looks_left) {
  const Search search = find_subscription(offer.topic);
  if (search.is_busy)
    return clerk_.post([this, offer, looks_left] { accept(offer, looks_left); }, kLookAgainWhenBusy);
  const bool is_there = search.found && find_link(*search.found, offer).link;
  if (is_there) return peers_.post(offer.publisher, [this, offer] { connect(offer); });
  if (looks_left > 0)
    clerk_.post([this, offer, looks_left] { accept(offer, looks_left - 1); }, kLookAgain);
  else
    ROS_DEBUG_STREAM("TZC: " << offer.topic << " from " << offer.publisher << ": the offer is for connection "
                             << offer.connection << ", which is not there");
}

bool UpgradeResponder::connected(const LinkPtr& link) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return channels_.count(link) != 0;
}

bool UpgradeResponder::codec_for(const Offer& offer, ros::Subscription& subscription,
                                 MessageCodec& codec) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  bool found = false;
  for (const MessageCodec& candidate : topics_.at(offer.topic)) {
    if (candidate.md5sum != offer.md5sum) continue;
    bool ser = false, is_wanted = false;
    subscription.getPublishTypes(ser, is_wanted, *candidate.type);
    if (!found || is_wanted) codec = candidate;
    found = true;
    if (is_wanted) break;
  }
  return found;
}

void UpgradeResponder::connect(const Offer& offer) {
  const auto again = [this, offer] { connect(offer); };
  const Search search = find_subscription(offer.topic);
  if (search.is_busy) return peers_.post(offer.publisher, again, kLookAgainWhenBusy);
  if (private_writes()) {  // any callback may write to a message that another one has kept
    peers_.post(kNoPeer, keep_all_ready_for_faults);
    if (!try_make_all_ready_for_faults()) return peers_.post(offer.publisher, again, kLookAgain);
  }
  const ros::SubscriptionPtr& subscription = search.found;
  const OfferedLink offered = subscription ? find_link(*subscription, offer) : OfferedLink();
  const LinkPtr& link = offered.link;
  MessageCodec codec;
  if (!link || connected(link) || !codec_for(offer, *subscription, codec)) return;
  const auto endpoint = std::make_shared<SubscriptionEndpoint>(subscription, link, offered.connection, codec);
  const auto is_foreign_uid = std::make_shared<bool>(false);
  Expected<std::shared_ptr<channel::Subscriber>> channel =
      channel::Subscriber::create(options_for(offer, link, endpoint, is_foreign_uid));
  if (!channel) return connection_failed(offer, channel.error(), *is_foreign_uid);
  ROS_DEBUG_STREAM("TZC: " << offer.topic << " from " << offer.publisher << " comes through shared memory");
  if ((*channel)->stats().copies_blocks) warn_of_copies(offer.topic);
  sync_point("accept: connected");
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    channels_[link] = {*channel, endpoint};
  }
  if (!(*channel)->stats().connected) forget(link);  // it ended before it was there to be forgotten
}

channel::SubscriberOptions UpgradeResponder::options_for(
    const Offer& offer, const LinkPtr& link, const std::shared_ptr<SubscriptionEndpoint>& endpoint,
    const std::shared_ptr<bool>& is_foreign_uid) {
  channel::SubscriberOptions options;
  options.address = offer.address;
  options.hello = offer.token;
  options.shared_thread = !endpoint->calls_directly();
  options.may_begin = [endpoint] { return endpoint->may_begin(); };
  if (trace::active) trace::name_channel(offer.address, {offer.topic, true});
  options.on_message = [endpoint](const channel::MessagePtr& message) { endpoint->take(message); };
  options.on_disconnect = [this, link, topic = offer.topic](const std::string& reason) {
    clerk_.post([this, link, topic, reason] {
      warn_of_end(link, topic, reason);
      forget(link);
    });
  };
  options.private_writes = private_writes();
  options.hands_over = true;  // each callback is readied (fault_ready_queue.h, direct_call.h, direct_queue.h)
  options.on_write = [this, topic = offer.topic] { clerk_.post([topic] { warn_of_write(topic); }); };
  options.authorize = [is_foreign_uid](const channel::Credentials& peer) {
    *is_foreign_uid =
        peer.uid != geteuid() && peer.uid != 0;  // root can read everything of this process anyway
    return !*is_foreign_uid;
  };
  return options;
}

// The publisher will offer again, and stops when it gets a refusal.
void UpgradeResponder::connection_failed(const Offer& offer, const Error& error, bool is_foreign_uid) {
  ROS_DEBUG_STREAM("TZC: " << offer.topic << " from " << offer.publisher
                           << " stays on TCPROS: " << error.text());
  const std::lock_guard<std::mutex> lock(mutex_);
  if (is_foreign_uid) foreign_uids_.insert(offer.token);
}

bool UpgradeResponder::look(std::vector<SubscriptionStatistics>& all) const {
  std::vector<std::string> topics;
  Channels channels;  // outside of the mutex, so that the last reference to one does not go under it
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    for (const auto& topic : topics_) topics.push_back(topic.first);
    channels = channels_;
  }
  all.clear();
  for (const std::string& topic : topics) {
    const Search search = find_subscription(topic);
    if (search.is_busy) return false;
    for (const LinkPtr& link : search.found ? tcp_links(*search.found) : std::vector<LinkPtr>()) {
      all.push_back(statistics_of(*link, topic));
      const auto shared = channels.find(link);
      if (shared != channels.end())
        add_shared(*shared->second.subscriber, shared->second.endpoint->limit(), all.back());
    }
  }
  return true;
}

void UpgradeResponder::forget(const LinkPtr& link) {
  Channel ended;
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto found = channels_.find(link);
  if (found == channels_.end()) return;
  ended = std::move(found->second);
  channels_.erase(found);
}

void UpgradeResponder::ask_publishers(const std::string& topic) {
  const Search search = find_subscription(topic);
  if (search.is_busy) return clerk_.post([this, topic] { ask_publishers(topic); }, kLookAgainWhenBusy);
  if (!search.found) return;
  for (const LinkPtr& link : tcp_links(*search.found))
    peers_.post(link->getPublisherXMLRPCURI(), [this, link, topic] { ask(link, topic, 1); });
}

// A publisher that does not know the method has no TZC, or attaches the topic later and offers then.
void UpgradeResponder::ask(const LinkPtr& link, const std::string& topic, int tries) {
  if (connected(link) || is_dropped(connection_of(*link))) return;
  XmlRpc::XmlRpcValue params;
  params[0] = kOfferVersion;
  params[1] = topic;
  params[2] = ros::this_node::getName();
  sync_point("request: calls");
  const XmlRpcReply reply = call_node(link->getPublisherXMLRPCURI(), kRequestMethod, params, kCallTimeout);
  if (reply.answered || reply.unknown) return;
  ROS_DEBUG_STREAM("TZC: " << topic << ", try " << tries << ": " << reply.status);
  const boost::weak_ptr<ros::TransportPublisherLink> weak = link;
  const auto again = [this, weak, topic, tries] {
    if (const LinkPtr waiting = weak.lock()) ask(waiting, topic, tries + 1);
  };
  peers_.post(link->getPublisherXMLRPCURI(), again, pause_after(tries));
  if (tries == upgrade_attempts_until_warning())
    TZC_WARN_THROTTLED_FOR(topic + " from " + link->getCallerID(), 10,
                           "TZC: " << topic << " stays on TCPROS after " << tries
                                   << " tries: " << reply.status
                                   << "; does the publisher run, and does this address lead to it "
                                      "(ROS_IP, ROS_HOSTNAME)?");
  sync_point("request: waits");
}

}  // namespace detail
}  // namespace tzc
