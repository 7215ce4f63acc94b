// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <memory>
#include <set>
#include <utility>

#include "posix/poller.h"

namespace tzc {
namespace channel {

/// Callbacks of the service thread. It never runs two of one watcher at a time.
class Watcher {
 public:
  virtual ~Watcher() = default;
  virtual void on_event(const posix::Poller::Event& event) = 0;
  virtual void on_deadline() {}
};

/// The service's watchers, by key, and when they want to be called. Not thread-safe.
class Watchers {
 public:
  using Clock = std::chrono::steady_clock;

  /// Returns its key.
  std::uint64_t add(std::shared_ptr<Watcher> watcher);
  /// Null: none has that key.
  std::shared_ptr<Watcher> find(std::uint64_t key) const;
  std::shared_ptr<Watcher> remove(std::uint64_t key);
  /// In place of the deadline that it has. True: no other is earlier.
  bool set_deadline(std::uint64_t key, Clock::time_point when);
  /// The one whose deadline came first, and has no deadline then. Null: nobody's has come.
  std::shared_ptr<Watcher> take_due(Clock::time_point now);
  /// max(): there is none.
  Clock::time_point first_deadline() const;

 private:
  struct Entry {
    std::shared_ptr<Watcher> watcher;
    Clock::time_point deadline = Clock::time_point::max();  // then it is not in `due_`
  };

  std::uint64_t next_key_ = 0;
  std::map<std::uint64_t, Entry> entries_;
  std::set<std::pair<Clock::time_point, std::uint64_t>> due_;
};

}  // namespace channel
}  // namespace tzc
