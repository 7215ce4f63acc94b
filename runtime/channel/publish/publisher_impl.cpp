// SPDX-License-Identifier: BSD-3-Clause
#include "channel/publish/publisher_impl.h"

#include <unistd.h>

#include <algorithm>

#include "trace/trace.h"

namespace tzc {
namespace channel {
namespace {

/// Without `authorize` all publishers admit the same processes.
Expected<std::shared_ptr<SegmentMemory>> default_memory(const PublisherOptions& publisher) {
  MemoryOptions options;
  options.queue_size = publisher.queue_size;
  options.pooled = !publisher.authorize;
  return SegmentMemory::create(options);
}

Expected<BellPull> bell_of(Peer& peer) {
  if (!peer.has_doorbell) return BellPull();
  Error error;
  error.what = "use a doorbell without its file (too many open files here?)";
  if (!peer.doorbell) return error;
  error.what = "use number " + std::to_string(peer.doorbell_number) + " of a doorbell";
  if (peer.doorbell_number >= doorbell_numbers) return error;
  auto doorbell = Doorbell::open(std::move(peer.doorbell), peer.doorbell_bytes);
  if (!doorbell) return doorbell.error();
  return BellPull{std::move(*doorbell), peer.doorbell_number};
}

}  // namespace

Expected<std::shared_ptr<PublisherImpl>> PublisherImpl::create(PublisherOptions options) {
  const auto service = Service::instance();
  if (!service) return service.error();
  if (!options.memory) {
    const auto memory = default_memory(options);
    if (!memory) return memory.error();
    options.memory = *memory;
  }
  auto entrance = options.address.empty() ? Entrance::of_process() : Entrance::at(options.address);
  if (!entrance) return entrance.error();
  auto publisher = std::make_shared<PublisherImpl>(std::move(options), std::move(*entrance), **service);
  publisher->enter();
  return publisher;
}

PublisherImpl::PublisherImpl(PublisherOptions options, std::shared_ptr<Entrance> entrance, Service& service)
    : options_(std::move(options)), entrance_(std::move(entrance)), service_(service) {}

void PublisherImpl::enter() {
  number_ = entrance_->enter(weak_from_this());
  address_ = entrance_->address_of(number_);
}

std::size_t PublisherImpl::publish(const RecordPtr& record) {
  const std::lock_guard<std::mutex> lock(mutex_);
  ++past_.published;
  if (!record) ++past_.not_records;
  return static_cast<std::size_t>(
      std::count_if(connections_.begin(), connections_.end(),
                    [&record](const auto& connection) { return connection->send(record); }));
}

std::vector<ConnectionPtr> PublisherImpl::connections() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return {connections_.begin(), connections_.end()};
}

PublisherStats PublisherImpl::stats() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  PublisherStats stats = past_;
  for (const auto& connection : connections_) {
    const ConnectionStats one = connection->stats();
    stats.sent += one.sent;
    stats.dropped += one.dropped;
    stats.subscribers += connection->alive() ? 1 : 0;
  }
  stats.refused_peers = refused_peers_;
  stats.accept_failures = accept_failures_;
  return stats;
}

void PublisherImpl::shutdown() {
  closed_ = true;
  entrance_->leave(number_);
  service_.synchronize();
  std::vector<std::shared_ptr<ConnectionImpl>> connections;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    connections.swap(connections_);
  }
  for (const auto& connection : connections) connection->close();
  entrance_.reset();
}

bool PublisherImpl::considers(const Credentials& peer) const {
  return options_.authorize || peer.uid == ::geteuid();
}

bool PublisherImpl::authorized(const Peer& peer) const {
  return !options_.authorize || options_.authorize(peer.credentials, peer.hello);
}

void PublisherImpl::admit(posix::FileDescriptor socket, Peer peer) {
  if (closed_) return refuse(socket.get(), "the publisher is closing");
  if (!authorized(peer)) {
    ++refused_peers_;
    return refuse(socket.get(), "the publisher did not authorize this subscriber");
  }
  Error failure;
  const std::string hello = peer.hello;
  const auto connection = connect(socket, std::move(peer), failure);
  if (!connection) {
    ++accept_failures_;
    if (socket) refuse(socket.get(), failure.text());
    if (options_.on_failure) options_.on_failure(hello, failure);
    return;
  }
  if (options_.on_connect) options_.on_connect(connection);
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!closed_) connections_.push_back(connection);
  }
  connection->uncork();
  if (closed_) connection->close();  // on_connect destroyed the publisher
}

std::shared_ptr<ConnectionImpl> PublisherImpl::connect(posix::FileDescriptor& socket, Peer peer,
                                                       Error& failure) {
  auto page = SharedPage::create(first_sequence);
  if (!page) {
    failure = page.error();
    return nullptr;
  }
  auto bell = bell_of(peer);
  if (!bell) {
    failure = bell.error();
    return nullptr;
  }
  const char* const name = trace::active ? trace::keep(trace::name_of_channel(address()).topic) : "";
  const InFlightLimit limit{options_.queue_size, peer.takes_promptly ? options_.buffered_bytes : 0};
  ConnectionImpl::Options options{limit, options_.keeps_undelivered, std::move(*bell), name};
  auto connection = std::make_shared<ConnectionImpl>(std::move(socket), std::move(peer), std::move(*page),
                                                     std::move(options), weak_from_this());
  const Status started = connection->start(service_);
  if (started) return connection;
  failure = started.error();
  return nullptr;
}

void PublisherImpl::disconnected(const std::shared_ptr<ConnectionImpl>& connection) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto found = std::find(connections_.begin(), connections_.end(), connection);
    if (found == connections_.end()) return;
    connections_.erase(found);
    const ConnectionStats stats = connection->stats();
    past_.sent += stats.sent;
    past_.dropped += stats.dropped;
  }
  if (!closed_ && options_.on_disconnect) options_.on_disconnect(connection);
}

}  // namespace channel
}  // namespace tzc
