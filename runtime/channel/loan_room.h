// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

#include "channel/service.h"

namespace tzc {
namespace channel {

/// How many sockets one process lends another at a time. What a program connects itself must find descriptors also while
/// all of TZC's connections are busy, and a process that stopped, and reads no loan, must not keep other
/// processes from getting theirs. Thread-safe.
class LoanRoom {
 public:
  explicit LoanRoom(Service& service) : service_(service) {}

  /// The room of one loan, free again with this object, which must not outlive the LoanRoom.
  class Taken {
   public:
    explicit Taken(LoanRoom& room) : room_(room) {}
    ~Taken() { room_.give_back(); }
    Taken(const Taken&) = delete;
    Taken& operator=(const Taken&) = delete;

   private:
    LoanRoom& room_;
  };

  /// Null: too many are open. The service calls on_deadline() of this key's watcher when there is room again, and before
  /// those who began to wait later.
  std::unique_ptr<Taken> take(std::uint64_t key);
  /// At least half of them are open.
  bool is_scarce() const;
  /// Somebody waits for room.
  bool is_wanted() const;

 private:
  void give_back();

  Service& service_;
  mutable std::mutex mutex_;
  std::size_t open_ = 0;
  std::vector<std::uint64_t> waiting_;
};

}  // namespace channel
}  // namespace tzc
