// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <functional>
#include <map>
#include <mutex>
#include <string>

#include "roscpp/monotonic_condition.h"

namespace tzc {
namespace detail {

/// A few threads for jobs that wait for other processes. Jobs of one peer run one at a time, in order of
/// their due time; jobs of different peers run in parallel, so that a stopped process delays only its own
/// jobs:
///
///   post(peer, job) -> the peer's own queue -> a free thread -> in time: the peer's next job
///                                                           -> slow:    a pause, doubled each time, and from then on
///                                                                       at most half of the threads for slow peers
///
/// Threads start when they are needed and end when they have been idle for some seconds. Thread-safe.
class PeerPool {
 public:
  using Job = std::function<void()>;
  using Clock = std::chrono::steady_clock;

  struct Limits {
    std::size_t threads = 4;
    std::chrono::milliseconds slow{1000};        ///< a job that takes longer makes its peer a slow one
    std::chrono::milliseconds first_pause{500};  ///< of a slow peer
    std::chrono::milliseconds longest_pause{16000};
    std::chrono::microseconds idle{std::chrono::seconds(5)};  ///< a thread without jobs ends after this time
  };

  PeerPool() : PeerPool(Limits()) {}
  explicit PeerPool(const Limits& limits) : limits_(limits) {}
  /// Waits for running jobs; the others are dropped.
  ~PeerPool();
  PeerPool(const PeerPool&) = delete;
  PeerPool& operator=(const PeerPool&) = delete;

  void post(const std::string& peer, Job job, std::chrono::microseconds delay = std::chrono::microseconds(0));

 private:
  struct Peer {
    std::multimap<Clock::time_point, Job> jobs;
    bool busy = false;
    int slow_jobs = 0;  ///< in a row
    Clock::time_point not_before;
  };
  using Peers = std::map<std::string, Peer>;

  /// \name Under mutex_
  /// @{
  void forget_idle();
  void start_thread();
  Clock::time_point due(const Peer& peer) const;
  Peers::iterator earliest();
  void run_next(std::unique_lock<std::mutex>& lock, Peers::iterator peer);
  void finish(Peers::iterator peer, Clock::duration took);
  /// @}
  void run();

  const Limits limits_;
  std::mutex mutex_;
  MonotonicCondition wake_;
  Peers peers_;
  std::size_t threads_ = 0;
  std::size_t idle_ = 0;
  std::size_t serving_slow_ = 0;
  bool stopping_ = false;
};

}  // namespace detail
}  // namespace tzc
