// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>

#include "channel/connect/loan_room.h"
#include "channel/connect/trunk.h"
#include "channel/wait/service.h"
#include "posix/file_descriptor.h"

namespace tzc {
namespace channel {

/// The publisher's end of a connection's socket. Where the connection has a trunk, that socket is a loan: it is given up when
/// nothing crosses it, and another one is lent when something has to. Not thread-safe.
class SendingSocket {
 public:
  /// `place`: on the connection's trunk. Null: it has none.
  SendingSocket(posix::FileDescriptor socket, std::unique_ptr<TrunkPlace> place);
  /// From now on the service tells the watcher about the socket, and the trunk the listener.
  Status start(Service& service, std::shared_ptr<Watcher> watcher, std::weak_ptr<TrunkListener> listener);

  /// The socket, if need be one that is lent now. -1: it is closed, or none can be lent now; the watcher's on_deadline is called when
  /// it is time to try again.
  int open();
  /// -1: none is open.
  int get() const { return socket_.get(); }
  bool is_loan() const { return is_loan_; }
  void watch_writable(bool full);
  void call_at(Service::Clock::time_point when);
  /// For how long nothing has to cross a loan before it is given up: shorter when many are lent to that process.
  std::chrono::milliseconds patience() const;
  /// Another connection waits for a loan to end.
  bool is_wanted() const;
  /// The subscriber sends nothing more: watch only for its hang-up.
  void stop_reading();
  /// Closes a loan. What is in it may still be read; its end counts as a packet.
  void give_up();
  /// Tells the subscriber that nothing more comes. Returns whether that counts as a packet of the socket.
  bool end();
  /// The service sees a hang-up that this end causes.
  void break_off();
  bool broken_off() const { return broken_off_; }
  /// Stops watching, and closes all.
  void close();

 private:
  void lend();

  const bool is_loan_;
  posix::FileDescriptor socket_;
  std::unique_ptr<TrunkPlace> place_;
  std::shared_ptr<LoanRoom::Taken> room_;  // of the loan that is open
  Service* service_ = nullptr;
  std::uint64_t key_ = 0;
  bool writable_watched_ = false;
  bool broken_off_ = false;
};

}  // namespace channel
}  // namespace tzc
