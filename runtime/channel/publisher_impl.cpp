// SPDX-License-Identifier: BSD-3-Clause
#include "channel/publisher_impl.h"

#include <unistd.h>

#include <algorithm>

#include "posix/address.h"
#include "trace/trace.h"

namespace tzc {
namespace channel {
namespace {

constexpr int accepts_per_event = 16;
constexpr std::chrono::milliseconds pause_when_exhausted{100};

Expected<posix::Listener> listen_on(const std::string& address) {
  if (!address.empty()) return posix::Listener::listen(address);
  posix::remove_dead_sockets();
  return posix::Listener::listen(posix::generate_address());
}

Expected<std::shared_ptr<SegmentMemory>> default_memory(std::size_t queue_size) {
  MemoryOptions options;
  options.queue_size = queue_size;
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
    const auto memory = default_memory(options.queue_size);
    if (!memory) return memory.error();
    options.memory = *memory;
  }
  auto listener = listen_on(options.address);
  if (!listener) return listener.error();
  auto publisher = std::make_shared<PublisherImpl>(std::move(options), std::move(*listener), **service);
  const Status started = publisher->start();
  if (!started) return started.error();
  return publisher;
}

PublisherImpl::PublisherImpl(PublisherOptions options, posix::Listener listener, Service& service)
    : options_(std::move(options)), listener_(std::move(listener)), service_(service) {}

Status PublisherImpl::start() {
  const auto key = service_.add(listener_.fd(), true, false, shared_from_this());
  if (!key) return key.error();
  key_ = *key;
  return Success{};
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
  service_.remove(listener_.fd(), key_);
  std::vector<std::shared_ptr<ConnectionImpl>> connections;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    connections.swap(connections_);
  }
  for (const auto& connection : connections) connection->close();
  listener_ = posix::Listener();
}

// Without descriptors the listener would report the same peer at once again: stop watching for a moment.
void PublisherImpl::on_event(const posix::Poller::Event&) {
  for (int i = 0; i < accepts_per_event; ++i) {
    posix::FileDescriptor socket;
    switch (posix::accept_connection(listener_.fd(), socket)) {
      case posix::AcceptResult::accepted:
        greet(std::move(socket));
        break;
      case posix::AcceptResult::nothing:
        return;
      case posix::AcceptResult::exhausted:
        ++accept_failures_;
        service_.change(listener_.fd(), key_, false, false);
        service_.set_deadline(key_, Service::Clock::now() + pause_when_exhausted);
        return;
    }
  }
}

void PublisherImpl::on_deadline() {
  service_.change(listener_.fd(), key_, true, false);
}

void PublisherImpl::greet(posix::FileDescriptor socket) {
  const auto credentials = posix::peer_credentials(socket.get());
  const bool foreign_uid = !options_.authorize && credentials && credentials->uid != ::geteuid();
  if (!credentials || foreign_uid) {
    ++refused_peers_;
    refuse(socket.get(), "only processes of the publisher's user may subscribe");
    return;
  }
  if (!PendingPeer::start(service_, std::move(socket), *credentials, weak_from_this())) ++accept_failures_;
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
  const auto connection = connect(socket, std::move(peer), failure);
  if (!connection) {
    ++accept_failures_;
    if (socket) refuse(socket.get(), failure.text());
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
  const ConnectionImpl::Options options{options_.queue_size, options_.keeps_undelivered, std::move(*bell),
                                        name};
  auto connection = std::make_shared<ConnectionImpl>(std::move(socket), std::move(peer), std::move(*page),
                                                     options, weak_from_this());
  const Status started = connection->start(service_);
  return started ? connection : nullptr;
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
