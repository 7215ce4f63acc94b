// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>

#include "channel/hang_up_watch.h"
#include "channel/shared_page.h"
#include "posix/file_descriptor.h"
#include "tzc/channel.h"

namespace tzc {
namespace channel {

/// A subscriber's open connection: the socket and the shared page. Every message holds it, because the
/// publisher takes everything back when the socket hangs up.
class Link {
 public:
  /// Connects and shakes hands, within options.handshake_timeout. With a service, which then looks for the
  /// publisher's end, records may come through the ring.
  static Expected<std::shared_ptr<Link>> connect(const SubscriberOptions& options, Service* service);
  Link(posix::FileDescriptor socket, const Credentials& peer, Service* service);
  ~Link();
  /// On a socket that is connected already.
  Status shake_hands(const SubscriberOptions& options);

  int fd() const { return socket_.get(); }
  const Credentials& peer() const { return peer_; }
  std::uint32_t first_sequence() const { return first_sequence_; }
  std::atomic<std::uint64_t>& verdict() const { return page_.verdict(); }
  /// Null: everything comes through the socket.
  Ring* ring() const { return ring_; }
  /// No record comes any more but those that are on their way; a reader that sleeps on the ring looks again.
  void end();
  const std::atomic<bool>& ended() const { return ended_; }
  /// A forked copy must not speak for its parent.
  bool forked() const;
  /// Unsubscribes; the socket stays open. A reader blocked on it returns.
  void say_goodbye();

 private:
  Status say_hello(const SubscriberOptions& options) const;
  Status await_welcome(const SubscriberOptions& options);
  Status use_ring();
  Status accept_welcome(const std::uint8_t* data, std::size_t size, posix::FileDescriptor page);

  posix::FileDescriptor socket_;
  const Credentials peer_;
  const std::uint32_t epoch_;
  Service* const service_;
  SharedPage page_;
  Ring* ring_ = nullptr;
  std::atomic<bool> ended_{false};
  std::shared_ptr<HangUpWatch> watch_;
  std::uint32_t first_sequence_ = 0;
};

}  // namespace channel
}  // namespace tzc
