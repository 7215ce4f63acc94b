// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <mutex>

#include "channel/connect/loan_room.h"
#include "channel/wait/service.h"
#include "channel/wire/wire.h"
#include "posix/file_descriptor.h"
#include "tzc/credentials.h"

namespace tzc {
namespace channel {

/// One end of a connection that has a trunk. Called on the service thread.
class TrunkListener {
 public:
  virtual ~TrunkListener() = default;
  /// `socket`: the one that is lent.
  virtual void heard(TrunkWord word, posix::FileDescriptor socket) = 0;
  /// The other process is gone, or broke the protocol.
  virtual void trunk_lost() = 0;
};

class Trunk;

/// The same pid and uid. A pid that was used again is not noticed.
inline bool is_same_process(const Credentials& a, const Credentials& b) {
  return a.pid == b.pid && a.uid == b.uid;
}

/// A connection's number on a trunk; free again with this object.
class TrunkPlace {
 public:
  TrunkPlace(std::shared_ptr<Trunk> trunk, std::uint32_t number);
  ~TrunkPlace();
  TrunkPlace(const TrunkPlace&) = delete;
  TrunkPlace& operator=(const TrunkPlace&) = delete;

  Trunk& trunk() const { return *trunk_; }
  std::uint32_t number() const { return number_; }
  /// From now on the listener hears what is said under this number. False: the trunk is lost, and nobody will tell it so.
  bool listen(std::weak_ptr<TrunkListener> listener);
  /// Never blocks. What is said under one number arrives in order, or the trunk is lost.
  void tell(TrunkWord word);
  /// Never blocks, and keeps the order likewise. Holds `room` until the socket is sent, so that a peer that does not read cannot make this process keep
  /// sockets open.
  void lend(posix::FileDescriptor socket, std::shared_ptr<LoanRoom::Taken> room);

 private:
  const std::shared_ptr<Trunk> trunk_;
  const std::uint32_t number_;
};

/// The one socket that two processes keep open between them, however many connections they have: each end learns from it
/// that the other process ended, and what the other end of a connection has to say while that has no socket of its own.
/// Owned by the service while its socket is open. Thread-safe; calls listeners without a lock.
class Trunk final : public Watcher, public std::enable_shared_from_this<Trunk> {
 public:
  struct End {
    Credentials peer;
    std::uint64_t id;                     ///< its name in greetings
    bool closes_unused;                   ///< with the last connection
    std::size_t takes = ~std::size_t{0};  ///< so many loans at a time
  };
  static Expected<std::shared_ptr<Trunk>> start(Service& service, posix::FileDescriptor socket,
                                                const End& end);
  Trunk(Service& service, posix::FileDescriptor socket, const End& end);

  std::uint64_t id() const { return end_.id; }
  const Credentials& peer() const { return end_.peer; }
  /// Of the sockets that this process lends through it.
  LoanRoom& loans() { return loans_; }
  /// Null: that number is in use, or the socket is closed.
  std::unique_ptr<TrunkPlace> take(std::uint32_t number);
  /// One that is not in use. Null: the socket is closed.
  std::unique_ptr<TrunkPlace> take_any();

  /// No connection has a place on it.
  bool is_unused() const;

  void on_event(const posix::Poller::Event& event) override;
  void on_deadline() override;

 private:
  friend class TrunkPlace;
  struct Said {
    WordPacket packet;
    posix::FileDescriptor socket{};
    std::shared_ptr<LoanRoom::Taken> room{};
  };

  Status watch();
  bool listen(std::uint32_t number, std::weak_ptr<TrunkListener> listener);
  void leave(std::uint32_t number);
  void tell(Said said);
  bool hear_one(bool& open);
  void hear(const WordPacket& packet, posix::FileDescriptor socket);
  void flush();
  void watch_writable(bool full);
  void close_if_unused();
  void close();
  void lose();

  Service& service_;
  const End end_;
  const std::uint32_t epoch_;
  LoanRoom loans_;

  mutable std::mutex mutex_;
  posix::FileDescriptor socket_;
  std::uint64_t key_ = 0;
  std::uint32_t last_number_ = 0;
  std::map<std::uint32_t, std::weak_ptr<TrunkListener>> listeners_;
  std::deque<Said> waiting_;  // the socket takes no more now
  bool full_ = false;
};

}  // namespace channel
}  // namespace tzc
