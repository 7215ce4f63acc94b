// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/port.h"

#include <ros/console.h>
#include <ros/poll_manager.h>
#include <ros/publication.h>
#include <ros/this_node.h>
#include <ros/topic_manager.h>

#include <unistd.h>

#include <algorithm>

#include "roscpp/host_identity.h"
#include "roscpp/link_swap.h"
#include "roscpp/roscpp_access.h"
#include "roscpp/statistics_file.h"

namespace tzc {
namespace detail {

namespace access = roscpp_access;

namespace {

/// In the row of messages that roscpp has yet to number: one that went out with its number, which roscpp's
/// count has to skip when it gets there.
constexpr const void* kNumberedAlready = nullptr;

/// Ports by publication: two publishers of one topic share one.
struct Ports {
  std::mutex mutex;
  std::map<const ros::Publication*, std::weak_ptr<Port>> ports;
};

Ports& ports() {
  static auto* const instance = new Ports;  // outlives every publication
  return *instance;
}

/// What an offer says to every subscriber.
Offer offer_of(const ros::Publication& publication) {
  Offer offer;
  offer.topic = publication.getName();
  offer.md5sum = publication.getMD5Sum();
  offer.publisher = ros::this_node::getName();
  offer.identity = host_identity();
  return offer;
}

}  // namespace

std::shared_ptr<Port> Port::of(const ros::PublicationPtr& publication, const PublisherOptions& options,
                               Worker& worker, Worker& caller) {
  const std::lock_guard<std::mutex> lock(ports().mutex);
  std::weak_ptr<Port>& known = ports().ports[publication.get()];
  if (std::shared_ptr<Port> port = known.lock()) return port;
  MemoryOptions memory;
  memory.size = options.memory_size;
  memory.queue_size = publication->getMaxQueue();
  memory.policy = options.policy;
  memory.prefault = options.prefault;
  memory.name = publication->getName();
  Expected<std::shared_ptr<SegmentMemory>> segments = SegmentMemory::create(memory);
  if (!segments) {
    ROS_WARN_STREAM("TZC: " << publication->getName() << " stays on TCPROS: " << segments.error().text());
    return nullptr;
  }
  std::shared_ptr<Port> port(new Port(publication, *segments, options.on_exhausted, worker, caller));
  if (!port->listen(publication->getMaxQueue())) return nullptr;
  known = port;
  return port;
}

Port::Port(const ros::PublicationPtr& publication, std::shared_ptr<SegmentMemory> memory,
           OnExhausted on_exhausted, Worker& worker, Worker& caller)
    : publication_(publication),
      topic_(publication->getName()),
      segments_(std::move(memory)),
      memory_(segments_),
      on_exhausted_(on_exhausted),
      worker_(worker),
      records_(memory_, on_exhausted),
      offering_(std::make_shared<Offering>(offer_of(*publication), caller)) {}

Port::~Port() {
  {
    const std::lock_guard<std::mutex> lock(ports().mutex);
    for (auto it = ports().ports.begin(); it != ports().ports.end();)
      it = it->second.expired() ? ports().ports.erase(it) : std::next(it);
  }
  append_statistics(topic_, statistics());
  // Ending a channel waits for its callbacks, which take roscpp's locks; whoever ends a port may hold those.
  worker_.post([channel = std::move(channel_)]() mutable { channel.reset(); });
}

bool Port::listen(std::size_t queue_size) {
  const std::weak_ptr<Port> weak = weak_from_this();
  const auto on_worker = [weak, &worker = worker_](void (Port::*act)(const channel::ConnectionPtr&)) {
    return [weak, &worker, act](const channel::ConnectionPtr& connection) {
      worker.post([weak, act, connection] {
        if (const std::shared_ptr<Port> port = weak.lock()) (port.get()->*act)(connection);
      });
    };
  };
  channel::PublisherOptions options;
  options.queue_size = queue_size;
  options.memory = segments_;
  options.keeps_undelivered = true;
  options.authorize = [weak](const channel::Credentials& peer, const std::string& hello) {
    const std::shared_ptr<Port> port = weak.lock();
    return port && port->authorizes(peer, hello);
  };
  options.on_connect = on_worker(&Port::connected);
  options.on_disconnect = on_worker(&Port::disconnected);
  Expected<std::shared_ptr<channel::Publisher>> channel = channel::Publisher::create(std::move(options));
  if (!channel) {
    ROS_WARN_STREAM("TZC: " << topic_ << " stays on TCPROS: " << channel.error().text());
    return false;
  }
  channel_ = *channel;
  offering_->listens_at(channel_->address());
  return true;
}

bool Port::authorizes(const channel::Credentials& peer, const std::string& token) {
  if (!offering_->expects(token)) return false;
  if (peer.uid == geteuid()) return true;
  offering_->turn_away(token, "it belongs to another user");
  return false;
}

void Port::on_connect(const ros::SingleSubscriberPublisher& subscriber) {
  const ros::SubscriberLinkPtr& link = access::link_(const_cast<ros::SingleSubscriberPublisher&>(subscriber));
  if (const auto tcp = boost::dynamic_pointer_cast<ros::TransportSubscriberLink>(link))
    offering_->invite(tcp);
}

void Port::offer_again(const std::string& caller_id) {
  const ros::PublicationPtr publication = publication_.lock();
  if (!publication) return;
  ros::V_SubscriberLink links;
  {
    const boost::mutex::scoped_lock lock(access::subscriber_links_mutex_(*publication));
    links = access::subscriber_links_(*publication);
  }
  for (const ros::SubscriberLinkPtr& link : links) {
    const auto tcp = boost::dynamic_pointer_cast<ros::TransportSubscriberLink>(link);
    if (tcp && tcp->getDestinationCallerID() == caller_id) offering_->invite(tcp);
  }
}

PublisherStatistics Port::statistics() const {
  PublisherStatistics statistics = records_.statistics();
  statistics.shared_subscribers = links_;
  if (channel_) statistics.revoked = channel_->stats().dropped;
  return statistics;
}

bool Port::wants_pointer(const std::type_info& type) const {
  if (links_ > 0 && records_.knows(type)) return true;  // spares the walk over all links
  const ros::PublicationPtr publication = publication_.lock();
  bool serialize = false, by_pointer = false;
  if (publication) publication->getPublishTypes(serialize, by_pointer, type);
  return by_pointer;
}

std::uint32_t Port::take_sequence(const ros::SerializedMessage& message) {
  const ros::PublicationPtr publication = publication_.lock();
  if (!publication) return 0;
  const auto sequence = static_cast<std::uint32_t>(publication->getSequence() + unnumbered_.size());
  if (message.buf) {
    unnumbered_.push_back(message.buf.get());  // roscpp counts it when it works its queue off
    // Which it does at once only for subscribers that need bytes. A latched topic's bytes would lie there for
    // a while, and a newcomer would get them after the last message.
    ros::PollManager::instance()->getPollSet().signal();
  } else if (unnumbered_.empty()) {
    publication->incrementSequence();
  } else {
    unnumbered_.push_back(kNumberedAlready);
  }
  return sequence;
}

bool Port::publish_directly(const std::type_info& type, message::Encoded& encoded) {
  const ros::PublicationPtr publication = publication_.lock();
  if (!publication || publication->isLatched()) return false;
  const Standstill standstill(*publication);
  const ros::V_SubscriberLink& links = access::subscriber_links_(*publication);
  if (links_ == 0 || links.size() != links_ || standstill.queued() != 0) return false;
  const std::uint32_t sequence = publication->incrementSequence();
  const Shipment shipment = records_.of_encoded(type, encoded, sequence);
  for (const ros::SubscriberLinkPtr& link : links) static_cast<SharedLink&>(*link).deliver(shipment);
  return true;
}

Shipment Port::pointer_record(const ros::SerializedMessage& message) {
  return records_.of_pointer(message, links_, [&] { return take_sequence(message); });
}

void Port::saw_serialized(const ros::SerializedMessage& message) {
  if (unnumbered_.empty() || unnumbered_.front() != message.buf.get()) return;
  unnumbered_.pop_front();
  count_numbered();
}

void Port::track_queue(const std::vector<ros::SerializedMessage>& queue) {
  const auto known = std::count_if(unnumbered_.begin(), unnumbered_.end(),
                                   [](const void* message) { return message != kNumberedAlready; });
  for (std::size_t i = static_cast<std::size_t>(known); i < queue.size(); ++i)
    unnumbered_.push_back(queue[i].buf.get());
}

void Port::forget_queue() {
  unnumbered_.erase(std::remove_if(unnumbered_.begin(), unnumbered_.end(),
                                   [](const void* message) { return message != kNumberedAlready; }),
                    unnumbered_.end());
  count_numbered();
}

void Port::count_numbered() {
  const ros::PublicationPtr publication = publication_.lock();
  for (; !unnumbered_.empty() && unnumbered_.front() == kNumberedAlready; unnumbered_.pop_front())
    if (publication) publication->incrementSequence();
}

std::shared_ptr<Port> find_port(const std::string& topic) {
  const ros::PublicationPtr publication = ros::TopicManager::instance()->lookupPublication(topic);
  const std::lock_guard<std::mutex> lock(ports().mutex);
  const auto found = ports().ports.find(publication.get());
  return found == ports().ports.end() ? nullptr : found->second.lock();
}

}  // namespace detail
}  // namespace tzc
