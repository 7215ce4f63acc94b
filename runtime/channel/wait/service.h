// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "channel/wait/watchers.h"
#include "posix/poller.h"
#include "tzc/error.h"

namespace tzc {
namespace channel {

/// What the service thread calls because a signal handler asked for it.
class Callee {
 public:
  virtual ~Callee() = default;
  virtual void on_call() = 0;
};

/// The one thread that serves all connections of this process: new subscribers, full sockets that drain,
/// peers that leave. Started with the first publisher or subscriber, anew in a forked child. Thread-safe.
class Service {
 public:
  using Clock = Watchers::Clock;

  /// The running service of this process. Never destroyed. Error: no thread or descriptor left.
  static Expected<Service*> instance();

  /// Keeps the watcher alive and tells it about `fd` until remove().
  Expected<std::uint64_t> add(int fd, bool readable, bool writable, std::shared_ptr<Watcher> watcher);
  void change(int fd, std::uint64_t key, bool readable, bool writable);
  /// \name Another descriptor of a watcher that was added
  /// @{
  Status watch(int fd, std::uint64_t key, bool readable, bool writable);
  void unwatch(int fd);
  /// @}
  /// on_deadline will be called once at that time, in the order of these times.
  void set_deadline(std::uint64_t key, Clock::time_point when);
  /// Removes the watcher. A call to it may be running, and one more may follow.
  void forget(int fd, std::uint64_t key);
  /// Removes the watcher. No call to it runs afterwards, unless the service thread itself calls this.
  void remove(int fd, std::uint64_t key);
  /// Calls it whenever call_all was called, for as long as it lives.
  void add_callee(std::weak_ptr<Callee> callee);
  /// Async-signal-safe.
  void call_all() noexcept;
  /// Waits for every call that runs now; returns at once on the service thread.
  void synchronize();

 private:
  static Expected<Service*> start();
  explicit Service(std::unique_ptr<posix::Poller> poller);
  void run();
  void run_deadlines();
  void run_calls();
  int timeout_ms();
  std::shared_ptr<Watcher> find(std::uint64_t key);
  std::shared_ptr<Watcher> next_due(Clock::time_point now);
  void end_round();

  const std::unique_ptr<posix::Poller> poller_;
  const std::uint32_t epoch_;
  std::atomic<bool> called_{false};
  std::thread::id thread_id_;

  std::mutex mutex_;
  std::condition_variable round_ended_;
  std::uint64_t rounds_ = 0;  // of calls to watchers
  bool in_round_ = false;
  Watchers watchers_;
  std::vector<std::weak_ptr<Callee>> callees_;
};

}  // namespace channel
}  // namespace tzc
