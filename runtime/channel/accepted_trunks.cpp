// SPDX-License-Identifier: BSD-3-Clause
#include "channel/accepted_trunks.h"

#include <utility>

#include "channel/pending_peer.h"
#include "posix/nonce.h"
#include "posix/packet.h"

namespace tzc {
namespace channel {

void AcceptedTrunks::accept(Service& service, posix::FileDescriptor socket, const Credentials& peer) {
  const TrunkWelcome welcome{PacketKind::trunk_welcome, wire_version, posix::random_number()};
  posix::send_packet(socket.get(), &welcome, sizeof welcome);  // before the service thread hears anything
  const auto trunk = Trunk::start(service, std::move(socket), {peer, welcome.id, false});
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
