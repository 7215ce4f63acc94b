// SPDX-License-Identifier: BSD-3-Clause
#include "channel/connect/pending_peer.h"

#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <map>
#include <mutex>

#include "channel/wire/wire.h"
#include "posix/futex.h"
#include "posix/packet.h"

namespace tzc {
namespace channel {
namespace {

constexpr std::chrono::seconds time_for_hello{5};
// Limits for peers that have not sent Hello: they must not use up this process's descriptors, and peers of
// other users must not keep this user's peers from connecting.
constexpr int most_of_own_user = 256;
constexpr int most_of_another_user = 16;
constexpr int most_of_other_users = 64;

/// Counts pending peers by user. Thread-safe.
class Places {
 public:
  bool take(uid_t user) {
    const std::lock_guard<std::mutex> lock(mutex_);
    const bool own = user == ::geteuid();
    int& taken = by_user_[user];
    const bool accepted =
        own ? taken < most_of_own_user : taken < most_of_another_user && of_others_ < most_of_other_users;
    if (accepted) ++taken;
    if (accepted && !own) ++of_others_;
    return accepted;
  }
  void release(uid_t user) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (user != ::geteuid()) --of_others_;
    if (--by_user_[user] == 0) by_user_.erase(user);
  }

 private:
  std::mutex mutex_;
  std::map<uid_t, int> by_user_;
  int of_others_ = 0;
};

Places& places() {
  static auto* const one = new Places;  // never destroyed: the service thread runs until the end
  return *one;
}

}  // namespace

bool parse_hello(const std::uint8_t* data, std::size_t size, Peer& peer, std::string& reason) {
  Hello packet{};
  reason = "this is not the protocol of TZC";
  if (size < offsetof(Hello, hello_bytes)) return false;
  std::memcpy(&packet, data, std::min(size, sizeof packet));
  if (packet.kind != PacketKind::hello || packet.magic != wire_magic) return false;
  reason = "the publisher speaks version " + std::to_string(wire_version) +
           " of the protocol, the subscriber " + std::to_string(packet.version) + ": update the older one";
  if (packet.version != wire_version) return false;
  reason = "the hello's length is wrong";
  if (size < sizeof packet || packet.hello_bytes > max_hello_bytes ||
      packet.hello_bytes != size - sizeof packet)
    return false;
  peer.takes_promptly = (packet.features & takes_promptly) != 0;
  peer.reads_ring = (packet.features & reads_ring) != 0 && posix::has_shared_futex();
  peer.has_doorbell = peer.reads_ring && (packet.features & has_doorbell) != 0;
  peer.doorbell_bytes = packet.doorbell_bytes;
  peer.doorbell_number = packet.doorbell_number;
  peer.publication = packet.publication;
  peer.is_trunk = (packet.features & is_trunk) != 0;
  if (peer.has_doorbell && (packet.features & has_trunk) != 0) peer.trunk.id = packet.trunk;
  peer.trunk.number = packet.trunk_number;
  peer.hello.assign(reinterpret_cast<const char*>(data) + sizeof packet, packet.hello_bytes);
  return true;
}

bool PendingPeer::start(Service& service, posix::FileDescriptor socket, const Credentials& credentials,
                        std::weak_ptr<PeerAdmission> admission) {
  if (!places().take(credentials.uid)) return false;
  const int fd = socket.get();
  auto peer = std::make_shared<PendingPeer>(service, std::move(socket), credentials, std::move(admission));
  const auto key = service.add(fd, true, false, peer);
  if (!key) return false;
  peer->key_ = *key;
  service.set_deadline(*key, Service::Clock::now() + time_for_hello);
  return true;
}

PendingPeer::PendingPeer(Service& service, posix::FileDescriptor socket, const Credentials& credentials,
                         std::weak_ptr<PeerAdmission> admission)
    : service_(service),
      socket_(std::move(socket)),
      credentials_(credentials),
      admission_(std::move(admission)) {}

PendingPeer::~PendingPeer() {
  places().release(credentials_.uid);
}

void PendingPeer::on_event(const posix::Poller::Event&) {
  static std::uint8_t memory[max_packet_bytes];  // only the service thread comes here
  posix::ReceivedPacket packet;
  const auto result = posix::receive_packet(socket_.get(), memory, sizeof memory,
                                            posix::Waiting::return_at_once, true, packet);
  if (result == posix::ReceiveResult::nothing) return;
  const auto admission = admission_.lock();
  Peer peer{credentials_, {}};
  std::string reason;
  if (result == posix::ReceiveResult::packet && admission &&
      !parse_hello(memory, packet.size, peer, reason)) {
    admission->count_refused_peer();
    refuse(socket_.get(), reason);
    return end();
  }
  posix::FileDescriptor socket;
  service_.remove(socket_.get(), key_);
  socket.swap(socket_);
  peer.doorbell = std::move(packet.descriptors[0]);
  if (result == posix::ReceiveResult::packet && admission)
    admission->admit(std::move(socket), std::move(peer));
}

void PendingPeer::on_deadline() {
  if (const auto admission = admission_.lock()) admission->count_refused_peer();
  end();
}

void PendingPeer::end() {
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
