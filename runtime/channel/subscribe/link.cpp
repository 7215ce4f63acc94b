// SPDX-License-Identifier: BSD-3-Clause
#include "channel/subscribe/link.h"

#include <unistd.h>

#include "channel/connect/answer.h"
#include "channel/connect/publisher_address.h"
#include "channel/connect/trunk_to.h"
#include "channel/wire/wire.h"
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

Error at(const std::string& address, Error error) {
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
  if (place.service != nullptr && place.number) {
    auto trunk = trunk_to(*place.service, {address->socket, *peer}, options.handshake_timeout);
    if (!trunk) return at(options.address, trunk.error());
    place.trunk = std::move(*trunk);
  }
  auto link = std::make_shared<Link>(std::move(*socket), *peer, std::move(place));
  link->view_use_ = {view_writes(options), options.hands_over};
  link->notice_ = WriteNotice::create(notice_service(options), options.on_write);
  const Status welcome = link->shake_hands(options, address->publication);
  if (!welcome) return welcome.error();
  return link;
}

Link::Link(posix::FileDescriptor socket, const Credentials& peer, RingPlace place)
    : sockets_(std::move(socket)),
      peer_(peer),
      epoch_(posix::fork_epoch()),
      place_(std::move(place)),
      notice_(WriteNotice::create(nullptr, nullptr)) {}

// A forked child must not end what its parent still uses.
Link::~Link() {
  if (forked()) return;
  if (watch_) watch_->stop();
  if (place_.trunk) place_.trunk->tell(TrunkWord::gone);
}

Status Link::shake_hands(const SubscriberOptions& options, std::uint64_t publication) {
  if (place_.trunk && !place_.trunk->listen(weak_from_this()))
    return at(options.address, subscribe_failed("the publisher closed the connection"));
  const Status greeted = say_hello(options, publication);
  if (!greeted) return greeted;
  const Status welcome = await_welcome(options.handshake_timeout);
  return welcome ? welcome : at(options.address, welcome.error());
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
  if (place_.trunk) {
    hello.features |= has_trunk;
    hello.trunk = place_.trunk->trunk().id();
    hello.trunk_number = place_.trunk->number();
  }
  const iovec parts[] = {{&hello, sizeof hello},
                         {const_cast<char*>(options.hello.data()), options.hello.size()}};
  // When the publisher is gone, its Refusal says why.
  if (posix::send_packet(sockets_.current(), parts, 2, &doorbell, doorbell < 0 ? 0 : 1) ==
      posix::SendResult::exhausted)
    return failed("subscribe: the system has no memory, or too many descriptors are in flight",
                  options.address);
  return Success{};
}

Status Link::await_welcome(std::chrono::milliseconds timeout) {
  Answer answer;
  const Status answered = answer.await(sockets_.current(), timeout);
  if (!answered) return answered;
  Welcome welcome{};
  if (!answer.parse(PacketKind::welcome, welcome))
    return subscribe_failed("not a TZC publisher of this version");
  auto opened = SharedPage::open(answer.take_descriptor(), welcome.page_bytes);
  if (!opened) return opened.error();
  page_ = std::move(*opened);
  first_sequence_ = welcome.first_sequence;
  return place_.service != nullptr && (welcome.features & reads_ring) != 0 ? use_ring(welcome.features)
                                                                           : Status(Success{});
}

// Who has a trunk hears there of the publisher's end.
Status Link::use_ring(std::uint32_t features) {
  ring_ = &page_.ring();
  if (place_.trunk && (features & has_trunk) != 0) {
    sockets_.are_lent();
    return Success{};
  }
  auto watch = HangUpWatch::start(*place_.service, sockets_.current(), *this);
  if (!watch) return watch.error();
  watch_ = std::move(*watch);
  return Success{};
}

void Link::heard(TrunkWord word, posix::FileDescriptor socket) {
  if (word == TrunkWord::lend && sockets_.lend(std::move(socket))) return look_again();
  end();
}

void Link::end() {
  ended_ = true;
  if (place_.trunk) sockets_.stop_receiving();
  look_again();
}

void Link::look_again() {
  if (place_.number)
    place_.number->doorbell()->ring(place_.number->value());
  else if (ring_ != nullptr)
    wake_reader(*ring_);
}

void Link::unsubscribe() {
  const Unsubscribe unsubscribe{PacketKind::unsubscribe};
  if (sockets_.lent())
    place_.trunk->tell(TrunkWord::unsubscribe);
  else
    posix::send_packet(sockets_.current(), &unsubscribe, sizeof unsubscribe);
  sockets_.stop_receiving();
  end();
}

}  // namespace channel
}  // namespace tzc
