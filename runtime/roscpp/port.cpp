// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/port.h"

#include <ros/connection.h>
#include <ros/console.h>
#include <ros/poll_manager.h>
#include <ros/publication.h>
#include <ros/topic_manager.h>

#include <unistd.h>

#include <algorithm>

#include "roscpp/link_swap.h"
#include "roscpp/roscpp_access.h"
#include "roscpp/statistics_file.h"

namespace tzc {
namespace detail {

namespace access = roscpp_access;

namespace {

/// How often a link that waits for TCPROS to drain is looked at again.
constexpr std::chrono::milliseconds kDrainPoll(1);

/// In the row of messages that roscpp has yet to number: one that went out with its number, which roscpp's
/// count has to skip when it gets there.
constexpr const void* kNumberedAlready = nullptr;

/// Ports by publication: two publishers of one topic share one.
struct Ports {
  std::mutex mutex;
  std::map<const ros::Publication*, std::weak_ptr<Port>> ports;
};

Ports& ports() {
  static Ports instance;
  return instance;
}

}  // namespace

std::shared_ptr<Port> Port::of(const ros::PublicationPtr& publication, const PublisherOptions& options,
                               Worker& worker) {
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
  std::shared_ptr<Port> port(new Port(publication, *segments, options.on_exhausted, worker));
  if (!port->listen(publication->getMaxQueue())) return nullptr;
  known = port;
  return port;
}

Port::Port(const ros::PublicationPtr& publication, std::shared_ptr<SegmentMemory> memory,
           OnExhausted on_exhausted, Worker& worker)
    : publication_(publication),
      topic_(publication->getName()),
      md5sum_(publication->getMD5Sum()),
      segments_(std::move(memory)),
      memory_(segments_),
      on_exhausted_(on_exhausted),
      worker_(worker),
      records_(memory_, on_exhausted) {}

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
  const auto with_port = [weak](void (Port::*act)(const channel::ConnectionPtr&)) {
    return [weak, act](const channel::ConnectionPtr& connection) {
      if (const std::shared_ptr<Port> port = weak.lock()) (port.get()->*act)(connection);
    };
  };
  channel::PublisherOptions options;
  options.queue_size = queue_size;
  options.memory = segments_;
  options.authorize = [weak](const channel::Credentials& peer, const std::string& hello) {
    const std::shared_ptr<Port> port = weak.lock();
    return port && peer.uid == geteuid() && port->expected(hello, false);
  };
  options.on_connect = with_port(&Port::connected);
  options.on_disconnect = with_port(&Port::disconnected);
  Expected<std::shared_ptr<channel::Publisher>> channel = channel::Publisher::create(std::move(options));
  if (!channel) {
    ROS_WARN_STREAM("TZC: " << topic_ << " stays on TCPROS: " << channel.error().text());
    return false;
  }
  channel_ = *channel;
  return true;
}

PublisherStatistics Port::statistics() const {
  PublisherStatistics statistics = records_.statistics();
  statistics.shared_subscribers = shared_subscribers_;
  return statistics;
}

bool Port::wants_pointer(const std::type_info& type) const {
  if (shared_subscribers_ > 0 && records_.knows(type)) return true;  // spares the walk over all links
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

void Port::connected(const channel::ConnectionPtr& connection) {
  const TcpLink tcp = expected(connection->hello(), true);
  const SharedLinkPtr link = tcp ? park(tcp, connection) : SharedLinkPtr();
  if (!link) return connection->close();
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    by_connection_[connection] = link;
  }
  watch(link);
  ROS_DEBUG_STREAM("TZC: " << topic_ << " to " << tcp->getDestinationCallerID()
                           << " goes through shared memory");
  go_live(link);
}

void Port::watch(const SharedLinkPtr& link) {
  const std::weak_ptr<Port> weak = weak_from_this();
  const boost::weak_ptr<SharedLink> weak_link = link;
  link->on_end([weak, weak_link] {
    const std::shared_ptr<Port> port = weak.lock();
    const SharedLinkPtr gone = weak_link.lock();
    if (port && gone) port->ended(gone);
  });
  if (link->parked()->getConnection()->isDropped()) ended(link);  // before the listener stood
}

SharedLinkPtr Port::park(const TcpLink& tcp, const channel::ConnectionPtr& connection) {
  const ros::PublicationPtr publication = publication_.lock();
  if (!publication) return SharedLinkPtr();
  const Standstill standstill(*publication);
  const auto link =
      boost::make_shared<SharedLink>(weak_from_this(), publication, tcp, connection, standstill.queued());
  if (!swap_link_locked(*publication, tcp, link)) return SharedLinkPtr();
  if (links_++ == 0)
    for (const ros::SerializedMessage& message : access::publish_queue_(*publication))
      unnumbered_.push_back(message.buf.get());
  ++shared_subscribers_;
  return link;
}

void Port::put_back(const SharedLinkPtr& link) {
  const ros::PublicationPtr publication = publication_.lock();
  if (!publication) return;
  const boost::mutex::scoped_lock lock(access::subscriber_links_mutex_(*publication));
  if (!swap_link_locked(*publication, link, link->parked())) return;
  if (--links_ == 0) forget_queue();
  --shared_subscribers_;
}

void Port::disconnected(const channel::ConnectionPtr& connection) {
  SharedLinkPtr link;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto found = by_connection_.find(connection);
    if (found == by_connection_.end()) return;
    link = found->second.lock();
    by_connection_.erase(found);
  }
  if (!link) return;
  put_back(link);
  ROS_DEBUG_STREAM("TZC: " << topic_ << " to " << link->getDestinationCallerID() << " is back on TCPROS");
}

void Port::ended(const SharedLinkPtr& link) {
  // With the TCPROS link in its old place, roscpp's own removal tells the user's disconnect callbacks.
  put_back(link);
  if (const ros::PublicationPtr publication = publication_.lock())
    publication->removeSubscriberLink(link->parked());
  link->connection()->close();
}

void Port::go_live(const SharedLinkPtr& link) {
  if (!link->connection()->alive() || link->try_go_live()) return;
  const std::weak_ptr<Port> weak = weak_from_this();
  const boost::weak_ptr<SharedLink> weak_link = link;
  const auto again = [weak, weak_link] {
    const std::shared_ptr<Port> port = weak.lock();
    const SharedLinkPtr waiting = weak_link.lock();
    if (port && waiting) port->go_live(waiting);
  };
  worker_.post(again, kDrainPoll);
}

std::shared_ptr<Port> find_port(const std::string& topic) {
  const ros::PublicationPtr publication = ros::TopicManager::instance()->lookupPublication(topic);
  const std::lock_guard<std::mutex> lock(ports().mutex);
  const auto found = ports().ports.find(publication.get());
  return found == ports().ports.end() ? nullptr : found->second.lock();
}

}  // namespace detail
}  // namespace tzc
