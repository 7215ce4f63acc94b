// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

#include "channel/wait/service.h"

namespace tzc {
namespace channel {

/// How many sockets one process lends another at a time. What a program connects itself must find descriptors also while
/// all of TZC's connections are busy, and a process that stopped, and reads no loan, must not keep other
/// processes from getting theirs. Thread-safe.
class LoanRoom {
 public:
  /// `most`: that the other process takes at a time.
  LoanRoom(Service& service, std::size_t most) : service_(service), most_taken_(most) {}
  /// That this process may lend, and takes, at a time.
  static std::size_t share_of_process();

  /// The room of one loan, free again with the last owner of this object, which must not outlive the LoanRoom.
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
  std::shared_ptr<Taken> take(std::uint64_t key);
  /// At least half of them are open.
  bool is_scarce() const;
  /// Somebody waits for room.
  bool is_wanted() const;

 private:
  void give_back();
  std::size_t most() const { return std::min(share_of_process(), most_taken_); }

  Service& service_;
  const std::size_t most_taken_;
  mutable std::mutex mutex_;
  std::size_t open_ = 0;
  std::vector<std::uint64_t> waiting_;
};

}  // namespace channel
}  // namespace tzc
