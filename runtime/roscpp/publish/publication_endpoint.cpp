// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/publish/publication_endpoint.h"

#include <ros/publication.h>
#include <ros/this_node.h>
#include <ros/topic_manager.h>

#include <unistd.h>

#include <algorithm>
#include <chrono>

#include "roscpp/descriptor_budget.h"
#include "roscpp/publish/memory_of_no_topic.h"
#include "roscpp/publish/publication_lock.h"
#include "roscpp/publish/queued_messages.h"
#include "roscpp/publish/socket_buffers.h"
#include "roscpp/publish/statistics_file.h"
#include "roscpp/roscpp_access.h"
#include "roscpp/throttled_warning.h"
#include "trace/trace.h"

namespace tzc {
namespace detail {

namespace access = roscpp_access;

namespace {

/// When to try again to open a channel.
constexpr std::chrono::seconds kAfterFailure(5);

struct KnownEndpoint {
  ros::PublicationWPtr publication;
  std::weak_ptr<PublicationEndpoint> endpoint;
};

/// Endpoints by publication: two publishers of one topic share one.
struct Endpoints {
  std::mutex mutex;
  std::map<const ros::Publication*, KnownEndpoint> endpoints;

  /// Under mutex. Null: there is none, or that of a publication which had the same address.
  std::shared_ptr<PublicationEndpoint> find(const ros::PublicationPtr& publication) const {
    const auto found = endpoints.find(publication.get());
    const bool is_known =
        found != endpoints.end() && publication && found->second.publication.lock() == publication;
    return is_known ? found->second.endpoint.lock() : nullptr;
  }
};

Endpoints& endpoints() {
  static auto* const instance = new Endpoints;  // outlives every publication
  return *instance;
}

/// The fields of an offer that are the same for every subscriber.
Offer offer_of(const ros::Publication& publication) {
  Offer offer;
  offer.topic = publication.getName();
  offer.md5sum = publication.getMD5Sum();
  offer.publisher = ros::this_node::getName();
  return offer;
}

MemoryOptions memory_options(ros::Publication& publication, const PublisherOptions& options) {
  MemoryOptions memory;
  memory.size = options.memory_size;
  memory.queue_size = publication.getMaxQueue();
  memory.policy = options.policy;
  memory.prefault = options.prefault;
  memory.name = publication.getName();
  memory.pooled = true;  // every topic is for all processes of this user
  return memory;
}

/// Of a memory whose size somebody chose a small part: the subscriber may hold half of it before it gets copies.
std::size_t room_for_bursts(const MemoryOptions& memory) {
  return memory.size == 0 ? room_for_a_burst() : std::min(room_for_a_burst(), memory.size / 16);
}

std::vector<ros::TransportSubscriberLinkPtr> tcp_links(const ros::PublicationPtr& publication) {
  std::vector<ros::TransportSubscriberLinkPtr> found;
  if (!publication) return found;
  ros::V_SubscriberLink links;  // outlives the lock: the last reference to one runs callbacks
  const boost::mutex::scoped_lock lock(access::subscriber_links_mutex_(*publication));
  links = access::subscriber_links_(*publication);
  for (const ros::SubscriberLinkPtr& link : links)
    if (auto tcp = boost::dynamic_pointer_cast<ros::TransportSubscriberLink>(link))
      found.push_back(std::move(tcp));
  return found;
}

}  // namespace

std::shared_ptr<PublicationEndpoint> PublicationEndpoint::of(const ros::PublicationPtr& publication,
                                                             const PublisherOptions& options, Worker& worker,
                                                             PeerPool& peers) {
  // No endpoint may end under this lock: its destructor takes it.
  const std::lock_guard<std::mutex> lock(endpoints().mutex);
  if (std::shared_ptr<PublicationEndpoint> endpoint = endpoints().find(publication)) return endpoint;
  KnownEndpoint& known = endpoints().endpoints[publication.get()];
  Expected<std::shared_ptr<SegmentMemory>> segments =
      SegmentMemory::create(memory_options(*publication, options));
  if (!segments) {
    TZC_WARN_THROTTLED_FOR(
        subject_of(segments.error().code, publication->getName()), 60,
        "TZC: " << publication->getName() << " stays on TCPROS: " << segments.error().text());
    return nullptr;
  }
  std::shared_ptr<PublicationEndpoint> endpoint(
      new PublicationEndpoint(publication, *segments, options.on_exhausted, worker, peers));
  // An alias: the links keep the endpoint with the stream, the migration keeps neither.
  endpoint->migration_->send_from(std::shared_ptr<PublicationStream>(endpoint, &endpoint->stream_));
  known = {publication, endpoint};
  note_topic_with_memory();
  return endpoint;
}

PublicationEndpoint::PublicationEndpoint(const ros::PublicationPtr& publication,
                                         std::shared_ptr<SegmentMemory> memory, OnExhausted on_exhausted,
                                         Worker& worker, PeerPool& peers)
    : publication_(publication),
      topic_(publication->getName()),
      segments_(std::move(memory)),
      memory_(segments_),
      worker_(worker),
      stream_(publication, segments_, on_exhausted),
      local_callbacks_(stream_.most_held_bytes(), peers),
      negotiator_(std::make_shared<UpgradeNegotiator>(offer_of(*publication), peers)),
      migration_(std::make_shared<LinkMigration>(publication, negotiator_, worker)) {}

PublicationEndpoint::~PublicationEndpoint() {
  {
    const std::lock_guard<std::mutex> lock(endpoints().mutex);
    for (auto it = endpoints().endpoints.begin(); it != endpoints().endpoints.end();)
      it = it->second.endpoint.expired() ? endpoints().endpoints.erase(it) : std::next(it);
  }
  append_statistics(topic_, statistics());
  // Ending a channel waits for its callbacks, which take roscpp's locks; and the thread that ends an endpoint may hold those.
  worker_.post([channel = std::move(channel_)]() mutable { channel.reset(); });
}

// Made with the first invitation: a topic without subscribers costs no socket.
bool PublicationEndpoint::is_listening() {
  const std::lock_guard<std::mutex> lock(channel_mutex_);
  if (channel_) return true;
  const ros::PublicationPtr publication = publication_.lock();
  return publication && listen(publication->getMaxQueue());
}

bool PublicationEndpoint::listen(std::size_t queue_size) {
  const std::weak_ptr<PublicationEndpoint> weak = weak_from_this();
  const std::weak_ptr<LinkMigration> migration = migration_;
  channel::PublisherOptions options;
  options.queue_size = queue_size;
  options.buffered_bytes = room_for_bursts(segments_->options());
  options.memory = segments_;
  options.keeps_undelivered = true;
  options.authorize = [weak](const channel::Credentials& peer, const std::string& hello) {
    const std::shared_ptr<PublicationEndpoint> endpoint = weak.lock();
    return endpoint && endpoint->authorizes(peer, hello);
  };
  options.on_connect = [migration](const channel::ConnectionPtr& connection) {
    if (const auto alive = migration.lock()) alive->connected_later(connection);
  };
  options.on_disconnect = [migration](const channel::ConnectionPtr& connection) {
    if (const auto alive = migration.lock()) alive->disconnected_later(connection);
  };
  options.on_failure = [weak](const std::string& hello, const Error& error) {
    if (const std::shared_ptr<PublicationEndpoint> endpoint = weak.lock())
      endpoint->could_not_connect(hello, error);
  };
  Expected<std::shared_ptr<channel::Publisher>> channel = channel::Publisher::create(std::move(options));
  if (!channel) {
    TZC_WARN_THROTTLED_FOR(subject_of(channel.error().code, topic_), 60,
                           "TZC: " << topic_ << " stays on TCPROS: " << channel.error().text());
    return false;
  }
  channel_ = *channel;
  if (trace::active) {
    trace::name_process(ros::this_node::getName());
    trace::name_channel(channel_->address(), {topic_, false});
  }
  negotiator_->listens_at(channel_->address());
  return true;
}

bool PublicationEndpoint::authorizes(const channel::Credentials& peer, const std::string& token) {
  if (!negotiator_->expects(token)) return false;
  if (peer.uid != geteuid()) {
    negotiator_->turn_away(token, "it belongs to another user");
    return false;
  }
  if (has_spare_descriptors()) return true;
  negotiator_->failed(token, "the publisher: " + descriptor_advice());
  return false;
}

void PublicationEndpoint::could_not_connect(const std::string& token, const Error& error) {
  negotiator_->failed(token, "the publisher: " + error.text());
  TZC_WARN_THROTTLED_FOR(topic_, 60,
                         "TZC: subscribers of " << topic_ << " stay on TCPROS for now: " << error.text());
}

void PublicationEndpoint::on_connect(const ros::SingleSubscriberPublisher& subscriber) {
  const ros::SubscriberLinkPtr& link = access::link_(const_cast<ros::SingleSubscriberPublisher&>(subscriber));
  if (const auto tcp = boost::dynamic_pointer_cast<ros::TransportSubscriberLink>(link)) invite(tcp);
}

void PublicationEndpoint::invite(const TcpLink& link) {
  if (!has_spare_descriptors())
    TZC_WARN_THROTTLED(60, "TZC: further subscribers of "
                               << topic_
                               << " and other topics stay on TCPROS for now: " << descriptor_advice());
  if (is_listening()) return negotiator_->invite(link);
  negotiator_->leave(link,
                     "the publisher could not open a channel and tries again soon; its warning says why");
  invite_later();
}

// One round at a time, for all that wait.
void PublicationEndpoint::invite_later() {
  {
    const std::lock_guard<std::mutex> lock(channel_mutex_);
    if (invites_later_) return;
    invites_later_ = true;
  }
  const auto again = [weak = weak_from_this()] {
    const std::shared_ptr<PublicationEndpoint> endpoint = weak.lock();
    if (!endpoint) return;
    {
      const std::lock_guard<std::mutex> lock(endpoint->channel_mutex_);
      endpoint->invites_later_ = false;
    }
    for (const TcpLink& link : tcp_links(endpoint->publication_.lock())) endpoint->invite(link);
  };
  worker_.post(again, kAfterFailure);
}

void PublicationEndpoint::offer_again(const std::string& caller_id) {
  for (const TcpLink& link : tcp_links(publication_.lock()))
    if (link->getDestinationCallerID() == caller_id) invite(link);
}

PublisherStatistics PublicationEndpoint::statistics() const {
  PublisherStatistics statistics = stream_.records().statistics();
  statistics.shared_subscribers = stream_.links();
  const std::lock_guard<std::mutex> lock(channel_mutex_);
  if (channel_) statistics.revoked = channel_->stats().dropped;
  return statistics;
}

EndpointStatistics PublicationEndpoint::look() const {
  EndpointStatistics seen;
  seen.topic = topic_;
  seen.counters = statistics();
  seen.memory = segments_->stats();
  const ros::PublicationPtr publication = publication_.lock();
  if (!publication) return seen;
  seen.type = publication->getDataType();
  const auto why_not = [this](const auto& link) { return negotiator_->why_not(link); };
  seen.has_links = read_links(*publication, why_not, seen.links);
  return seen;
}

bool PublicationEndpoint::wants_pointer(const std::type_info& type) const {
  if (stream_.links() > 0 && stream_.records().codecs().has(type))
    return true;  // spares the walk over all links
  const ros::PublicationPtr publication = publication_.lock();
  bool serialize = false, by_pointer = false;
  if (publication) publication->getPublishTypes(serialize, by_pointer, type);
  return by_pointer;
}

LocalMessage PublicationEndpoint::local_message(const std::type_info& type,
                                                const message::Encoded& encoded) const {
  const ros::PublicationPtr publication = publication_.lock();
  const MessageCodec* const codec = stream_.records().codecs().find(type);
  if (!publication || !codec) return {LocalView::unseen, nullptr};
  return local_callbacks_.prepare(*publication, *codec, encoded);
}

void PublicationEndpoint::send_queued() {
  // roscpp's own thread holds it while it sends the queue.
  const boost::recursive_mutex::scoped_lock lock(
      access::advertised_topics_mutex_(*ros::TopicManager::instance()));
  const ros::PublicationPtr publication = publication_.lock();
  if (!publication) return;
  bool waits = false;
  {
    const PublicationLock publication_lock(*publication);
    waits = stream_.waits(publication_lock.queued());
  }
  if (waits) send_queue(*publication);
}

void PublicationEndpoint::publish_numbered(const std::type_info& type, message::Encoded& encoded,
                                           Others others, const std::function<void()>& publish) {
  boost::unique_lock<boost::recursive_mutex> lock(
      access::advertised_topics_mutex_(*ros::TopicManager::instance()));
  const ros::PublicationPtr publication = publication_.lock();
  const MessageCodec* const codec = stream_.records().codecs().find(type);
  if (!codec || !publication || !publication->hasSubscribers()) {
    lock.unlock();
    return publish();
  }
  send_queued();
  {
    const PublicationLock publication_lock(*publication);
    write_number(*codec, encoded, stream_.foresee_number(publication_lock.queued()));
  }
  const bool is_counted = numbers_by_pointer(*publication, type);
  if (others == Others::publish) lock.unlock();
  publish();
  if (!is_counted) publication->incrementSequence();
}

// roscpp numbers what it serializes, and the first SharedLink what it sends. A message that only callbacks of this
// process get would have been serialized for them.
bool PublicationEndpoint::numbers_by_pointer(ros::Publication& publication,
                                             const std::type_info& type) const {
  bool serializes = false, by_pointer = false;
  publication.getPublishTypes(serializes, by_pointer, type);
  return serializes || publication.isLatched() || stream_.links() > 0;
}

bool PublicationEndpoint::publish_directly(const std::type_info& type, message::Encoded& encoded) {
  const ros::PublicationPtr publication = publication_.lock();
  if (!publication || publication->isLatched() || !fits_record(encoded)) return false;
  const PublicationLock lock(*publication);
  const std::vector<SharedLink*>& live = migration_->live_links();
  if (live.empty() || access::subscriber_links_(*publication).size() != live.size() || lock.queued() != 0)
    return false;
  const OutgoingMessage message = stream_.of_encoded(type, encoded);
  for (SharedLink* link : live) link->deliver(message);
  return true;
}

std::shared_ptr<PublicationEndpoint> find_endpoint(const std::string& topic) {
  const ros::PublicationPtr publication = ros::TopicManager::instance()->lookupPublication(topic);
  const std::lock_guard<std::mutex> lock(endpoints().mutex);
  return endpoints().find(publication);
}

// Locked outside of the mutex, which the destructor of an endpoint takes.
std::vector<std::shared_ptr<PublicationEndpoint>> all_endpoints() {
  std::vector<std::weak_ptr<PublicationEndpoint>> known;
  {
    const std::lock_guard<std::mutex> lock(endpoints().mutex);
    for (const auto& one : endpoints().endpoints) known.push_back(one.second.endpoint);
  }
  std::vector<std::shared_ptr<PublicationEndpoint>> alive;
  for (const auto& one : known)
    if (std::shared_ptr<PublicationEndpoint> endpoint = one.lock()) alive.push_back(std::move(endpoint));
  return alive;
}

}  // namespace detail
}  // namespace tzc
