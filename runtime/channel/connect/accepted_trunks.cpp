// SPDX-License-Identifier: BSD-3-Clause
#include "channel/connect/accepted_trunks.h"

#include <unistd.h>

#include <utility>

#include "channel/connect/pending_peer.h"
#include "posix/nonce.h"
#include "posix/packet.h"

namespace tzc {
namespace channel {

namespace {

// Of one user. An honest process has a trunk without a connection for a moment only.
constexpr std::size_t most_unused_of_own_user = 256;
constexpr std::size_t most_unused_of_another_user = 16;
constexpr std::size_t most_unused_of_other_users = 64;

}  // namespace

bool AcceptedTrunks::has_room_for(const Credentials& peer) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const uid_t own = ::geteuid();
  const auto unused = [this](auto of) {
    return trunks_.count_if([of](const Trunk& trunk) { return of(trunk.peer().uid) && trunk.is_unused(); });
  };
  const std::size_t same = unused([&peer](uid_t user) { return user == peer.uid; });
  if (peer.uid == own) return same < most_unused_of_own_user;
  return same < most_unused_of_another_user &&
         unused([own](uid_t user) { return user != own; }) < most_unused_of_other_users;
}

void AcceptedTrunks::accept(Service& service, posix::FileDescriptor socket, const Peer& peer) {
  if (!has_room_for(peer.credentials))
    return refuse(socket.get(), "too many processes of this user have come and subscribed to nothing");
  const TrunkWelcome welcome{PacketKind::trunk_welcome, wire_version, posix::random_number()};
  posix::send_packet(socket.get(), &welcome, sizeof welcome);  // before the service thread hears anything
  const auto trunk =
      Trunk::start(service, std::move(socket), {peer.credentials, welcome.id, false, peer.trunk.number});
  if (!trunk) return;
  const std::lock_guard<std::mutex> lock(mutex_);
  trunks_.keep(welcome.id, *trunk);
}

std::shared_ptr<Trunk> AcceptedTrunks::find(std::uint64_t id) {
  const std::lock_guard<std::mutex> lock(mutex_);
  return trunks_.find(id);
}

bool AcceptedTrunks::place(Peer& peer) {
  const auto trunk = find(peer.trunk.id);
  if (!trunk || !is_same_process(trunk->peer(), peer.credentials)) return false;
  peer.trunk.place = trunk->take(peer.trunk.number);
  return peer.trunk.place != nullptr;
}

}  // namespace channel
}  // namespace tzc
