// SPDX-License-Identifier: BSD-3-Clause
#include "channel/greeting.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstring>

#include "channel/hub.h"
#include "channel/wire.h"
#include "posix/futex.h"
#include "posix/packet.h"

namespace tzc {
namespace channel {
namespace {

constexpr std::chrono::seconds patience{5};
constexpr int most_greetings =
    256;  // of this process at a time: silent peers must not use up its descriptors

std::atomic<int> greetings{0};

}  // namespace

bool parse_hello(const std::uint8_t* data, std::size_t size, ConnectionImpl::Peer& peer,
                 std::string& reason) {
  Hello packet{};
  reason = "this is not the protocol of TZC";
  if (size < offsetof(Hello, hello_bytes)) return false;
  std::memcpy(&packet, data, std::min(size, sizeof packet));
  if (packet.kind != PacketKind::hello || packet.magic != wire_magic) return false;
  reason = "the publisher speaks version " + std::to_string(wire_version) +
           " of the protocol, the subscriber " + std::to_string(packet.version) + ": update the older one";
  if (packet.version != wire_version) return false;
  reason = "the greeting's length is wrong";
  if (size < sizeof packet || packet.hello_bytes > max_hello_bytes ||
      packet.hello_bytes != size - sizeof packet)
    return false;
  peer.reads_ring = (packet.features & reads_ring) != 0 && posix::has_shared_futex();
  peer.hello.assign(reinterpret_cast<const char*>(data) + sizeof packet, packet.hello_bytes);
  return true;
}

bool Greeting::start(Service& service, posix::FileDescriptor socket, const Credentials& credentials,
                     std::weak_ptr<Hub> hub) {
  if (greetings.load() >= most_greetings) return false;
  const int fd = socket.get();
  auto greeting = std::make_shared<Greeting>(service, std::move(socket), credentials, std::move(hub));
  const auto key = service.add(fd, true, false, greeting);
  if (!key) return false;
  greeting->key_ = *key;
  service.set_deadline(*key, Service::Clock::now() + patience);
  return true;
}

Greeting::Greeting(Service& service, posix::FileDescriptor socket, const Credentials& credentials,
                   std::weak_ptr<Hub> hub)
    : service_(service), socket_(std::move(socket)), credentials_(credentials), hub_(std::move(hub)) {
  ++greetings;
}

Greeting::~Greeting() {
  --greetings;
}

void Greeting::on_event(const posix::Poller::Event&) {
  static std::uint8_t memory[max_packet_bytes];  // only the service thread comes here
  posix::ReceivedPacket packet;
  const auto result = posix::receive_packet(socket_.get(), memory, sizeof memory,
                                            posix::Waiting::return_at_once, false, packet);
  if (result == posix::ReceiveResult::nothing) return;
  const auto hub = hub_.lock();
  ConnectionImpl::Peer peer{credentials_, {}};
  std::string reason;
  if (result == posix::ReceiveResult::packet && hub && !parse_hello(memory, packet.size, peer, reason)) {
    hub->count_refused_peer();
    refuse(socket_.get(), reason);
    return end();
  }
  posix::FileDescriptor socket;
  service_.remove(socket_.get(), key_);
  socket.swap(socket_);
  if (result == posix::ReceiveResult::packet && hub) hub->admit(std::move(socket), std::move(peer));
}

void Greeting::on_deadline() {
  if (const auto hub = hub_.lock()) hub->count_refused_peer();
  end();
}

void Greeting::end() {
  service_.remove(socket_.get(), key_);
  socket_.reset();
}

void refuse(int socket, const std::string& reason) {
  const Refusal refusal{PacketKind::refusal, wire_version};
  const iovec parts[] = {{const_cast<Refusal*>(&refusal), sizeof refusal},
                         {const_cast<char*>(reason.data()), reason.size()}};
  posix::send_packet(socket, parts, 2);
}

}  // namespace channel
}  // namespace tzc
