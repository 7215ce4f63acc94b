// SPDX-License-Identifier: BSD-3-Clause
#include "channel/connect/trunk_to.h"

#include <mutex>
#include <utility>

#include "channel/connect/answer.h"
#include "channel/wait/weak_map.h"
#include "posix/packet.h"
#include "posix/socket.h"

namespace tzc {
namespace channel {
namespace {

/// The trunks that this process opened. Thread-safe.
class Opened {
 public:
  std::shared_ptr<Trunk> find(const TrunkTarget& target) {
    const std::lock_guard<std::mutex> lock(mutex_);
    auto trunk = trunks_.find(target.socket);
    return trunk && is_same_process(trunk->peer(), target.process) ? trunk : nullptr;
  }
  void keep(const TrunkTarget& target, const std::shared_ptr<Trunk>& trunk) {
    const std::lock_guard<std::mutex> lock(mutex_);
    trunks_.keep(target.socket, trunk);
  }

 private:
  std::mutex mutex_;
  WeakMap<std::string, Trunk> trunks_;  // by the socket that they lead to
};

Opened& opened() {
  static auto* const one = new Opened;  // never destroyed: subscribers may live until the end
  return *one;
}

Expected<std::shared_ptr<Trunk>> open(Service& service, const TrunkTarget& target,
                                      std::chrono::milliseconds timeout) {
  auto socket = posix::connect_to(target.socket, timeout);
  if (!socket) return socket.error();
  const auto peer = posix::peer_credentials(socket->get());
  if (!peer) return peer.error();
  if (!is_same_process(*peer, target.process))
    return subscribe_failed("another process listens at the publisher's address now");
  Hello hello{PacketKind::hello, wire_magic, wire_version, 0, is_trunk};
  hello.trunk_number = static_cast<std::uint32_t>(LoanRoom::share_of_process());
  posix::send_packet(socket->get(), &hello, sizeof hello);  // a publisher that is gone does not answer
  Answer answer;
  const Status answered = answer.await(socket->get(), timeout);
  if (!answered) return answered.error();
  TrunkWelcome welcome{};
  if (!answer.parse(PacketKind::trunk_welcome, welcome))
    return subscribe_failed("not a TZC publisher of this version");
  return Trunk::start(service, std::move(*socket), {*peer, welcome.id, true});
}

}  // namespace

Expected<std::unique_ptr<TrunkPlace>> trunk_to(Service& service, const TrunkTarget& target,
                                               std::chrono::milliseconds timeout) {
  if (const auto trunk = opened().find(target)) {  // a forked child's parent's gives no place
    if (auto place = trunk->take_any()) return {std::move(place)};
  }
  auto trunk = open(service, target, timeout);
  if (!trunk) return trunk.error();
  opened().keep(target, *trunk);
  auto place = (*trunk)->take_any();
  if (!place) return subscribe_failed("the publisher closed the connection");
  return {std::move(place)};
}

}  // namespace channel
}  // namespace tzc
