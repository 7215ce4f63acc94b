// SPDX-License-Identifier: BSD-3-Clause
#include "channel/link.h"

#include <unistd.h>

#include <algorithm>
#include <cstring>

#include "channel/publisher_address.h"
#include "channel/wire.h"
#include "posix/fork_epoch.h"
#include "posix/packet.h"
#include "posix/socket.h"

namespace tzc {
namespace channel {
namespace {

Error failed(const std::string& what, const std::string& address) {
  Error error;
  error.what = what;
  error.where = address;
  return error;
}

// A publisher that runs as root is allowed: it can read everything of this process anyway.
bool trusted(const SubscriberOptions& options, const Credentials& peer) {
  if (options.authorize) return options.authorize(peer);
  return peer.uid == ::geteuid() || peer.uid == 0;
}

segment::ViewWrites view_writes(const SubscriberOptions& options) {
  if (!options.private_writes) return segment::ViewWrites::fault;
  return segment::can_make_private_pages() ? segment::ViewWrites::private_pages : segment::ViewWrites::copies;
}

// Also where the reader needs no service (portable build).
Service* notice_service(const SubscriberOptions& options) {
  if (!options.on_write || !options.own_thread) return nullptr;
  const auto service = Service::instance();
  return service ? *service : nullptr;
}

}  // namespace

Expected<std::shared_ptr<Link>> Link::connect(const SubscriberOptions& options, RingPlace place) {
  const auto address = parse_publisher_address(options.address);
  if (!address) return address.error();
  auto socket = posix::connect_to(address->socket, options.handshake_timeout);
  if (!socket) return socket.error();
  const auto peer = posix::peer_credentials(socket->get());
  if (!peer) return peer.error();
  if (!trusted(options, *peer))
    return failed("trust the publisher, a process of another user", options.address);
  auto link = std::make_shared<Link>(std::move(*socket), *peer, std::move(place));
  link->writes_ = view_writes(options);
  link->notice_ = WriteNotice::create(notice_service(options), options.on_write);
  const Status welcome = link->shake_hands(options, address->publication);
  if (!welcome) return welcome.error();
  return link;
}

Link::Link(posix::FileDescriptor socket, const Credentials& peer, RingPlace place)
    : socket_(std::move(socket)),
      peer_(peer),
      epoch_(posix::fork_epoch()),
      place_(std::move(place)),
      notice_(WriteNotice::create(nullptr, nullptr)) {}

// A forked child must not end the watch: its parent still uses it.
Link::~Link() {
  if (watch_ && !forked()) watch_->stop();
}

Status Link::shake_hands(const SubscriberOptions& options, std::uint64_t publication) {
  const Status greeted = say_hello(options, publication);
  return greeted ? await_welcome(options) : greeted;
}

bool Link::forked() const {
  return posix::forked_since(epoch_);
}

Status Link::say_hello(const SubscriberOptions& options, std::uint64_t publication) const {
  if (options.hello.size() > max_hello_bytes)
    return failed("subscribe with a hello over 32 KB", options.address);
  Hello hello{PacketKind::hello, wire_magic, wire_version, static_cast<std::uint32_t>(options.hello.size())};
  hello.publication = publication;
  if (options.own_thread && options.shared_thread) hello.features |= takes_promptly;
  if (place_.service != nullptr) hello.features |= reads_ring;
  int doorbell = -1;
  if (place_.service != nullptr && place_.number) {
    doorbell = place_.number->doorbell()->fd();
    hello.features |= has_doorbell;
    hello.doorbell_bytes = static_cast<std::uint32_t>(place_.number->doorbell()->size());
    hello.doorbell_number = place_.number->value();
  }
  const iovec parts[] = {{&hello, sizeof hello},
                         {const_cast<char*>(options.hello.data()), options.hello.size()}};
  // When the publisher is gone, its Refusal says why.
  if (posix::send_packet(fd(), parts, 2, &doorbell, doorbell < 0 ? 0 : 1) == posix::SendResult::exhausted)
    return failed("subscribe: the system has no memory, or too many descriptors are in flight",
                  options.address);
  return Success{};
}

Status Link::await_welcome(const SubscriberOptions& options) {
  std::uint8_t memory[1024];
  posix::ReceivedPacket packet;
  if (!posix::wait_readable(fd(), options.handshake_timeout))
    return failed("subscribe: the publisher did not answer in time", options.address);
  const auto result =
      posix::receive_packet(fd(), memory, sizeof memory, posix::Waiting::return_at_once, true, packet);
  if (result != posix::ReceiveResult::packet)
    return failed("subscribe: the publisher closed the connection", options.address);
  if (packet.descriptors_lost && packet.descriptor_count == 0)
    return failed("subscribe: too many open files in this process", options.address);
  Status accepted = accept_welcome(memory, packet.size, std::move(packet.descriptors[0]));
  if (accepted) return accepted;
  Error error = accepted.error();
  error.where = options.address;
  return error;
}

Status Link::accept_welcome(const std::uint8_t* data, std::size_t size, posix::FileDescriptor page) {
  Welcome welcome{};
  if (size < sizeof(Refusal)) return failed("subscribe: not a TZC publisher", "");
  std::memcpy(&welcome, data, std::min(size, sizeof welcome));
  if (welcome.kind == PacketKind::refusal) {
    const std::string reason(reinterpret_cast<const char*>(data) + sizeof(Refusal), size - sizeof(Refusal));
    return failed("subscribe: refused by the publisher: " + reason, "");
  }
  if (size != sizeof welcome || welcome.kind != PacketKind::welcome || welcome.version != wire_version)
    return failed("subscribe: not a TZC publisher of this version", "");
  auto opened = SharedPage::open(std::move(page), welcome.page_bytes);
  if (!opened) return opened.error();
  page_ = std::move(*opened);
  first_sequence_ = welcome.first_sequence;
  return place_.service != nullptr && (welcome.features & reads_ring) != 0 ? use_ring() : Status(Success{});
}

Status Link::use_ring() {
  ring_ = &page_.ring();
  auto watch = HangUpWatch::start(*place_.service, fd(), *this);
  if (!watch) return watch.error();
  watch_ = std::move(*watch);
  return Success{};
}

void Link::end() {
  ended_ = true;
  if (ring_ == nullptr) return;
  if (place_.number)
    place_.number->doorbell()->ring(place_.number->value());
  else
    wake_reader(*ring_);
}

void Link::unsubscribe() {
  const Unsubscribe unsubscribe{PacketKind::unsubscribe};
  const iovec whole{const_cast<Unsubscribe*>(&unsubscribe), sizeof unsubscribe};
  posix::send_packet(fd(), &whole, 1);
  posix::stop_receiving(fd());
  end();
}

}  // namespace channel
}  // namespace tzc
