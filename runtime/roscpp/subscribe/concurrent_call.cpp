// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/subscribe/concurrent_call.h"

#include <algorithm>
#include <condition_variable>
#include <cstddef>
#include <iterator>
#include <map>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

namespace tzc {
namespace detail {
namespace {

/// The calls that run, by callback. Thread-safe.
class RunningCalls {
 public:
  void begin(std::uint64_t id) {
    const std::lock_guard<std::mutex> lock(mutex_);
    calls_[id].threads.push_back(std::this_thread::get_id());
  }
  void end(std::uint64_t id) {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto ended = calls_.find(id);
    std::vector<std::thread::id>& threads = ended->second.threads;
    const auto own = std::find(threads.begin(), threads.end(), std::this_thread::get_id());
    threads.erase(own != threads.end() ? own : std::prev(own));  // a fiber may end on another thread
    if (threads.empty()) calls_.erase(ended);
    changed_.notify_all();
  }
  /// Waits for all but the calling thread's, which count as ended meanwhile: two that wait would wait for each other.
  void wait_for_others(std::uint64_t id) {
    std::unique_lock<std::mutex> lock(mutex_);
    const std::ptrdiff_t own = own_calls(id);
    if (own != 0) calls_[id].waiting += own;
    changed_.notify_all();
    changed_.wait(lock, [&] { return is_over(id); });
    if (own != 0) calls_[id].waiting -= own;
  }

 private:
  struct Calls {
    std::vector<std::thread::id> threads;  ///< one for each call
    std::ptrdiff_t waiting = 0;            ///< how many of those calls wait here
  };

  std::ptrdiff_t own_calls(std::uint64_t id) const {
    const auto found = calls_.find(id);
    if (found == calls_.end()) return 0;
    const std::vector<std::thread::id>& threads = found->second.threads;
    return std::count(threads.begin(), threads.end(), std::this_thread::get_id());
  }
  bool is_over(std::uint64_t id) const {
    const auto found = calls_.find(id);
    return found == calls_.end() ||
           static_cast<std::ptrdiff_t>(found->second.threads.size()) == found->second.waiting;
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  std::map<std::uint64_t, Calls> calls_;
};

/// Outlives every static that may still unsubscribe. It knows threads by their ids, not by a thread_local: of the thread that calls
/// exit() those are gone by then.
RunningCalls& running_calls() {
  static auto* const instance = new RunningCalls;
  return *instance;
}

}  // namespace

ConcurrentCall::ConcurrentCall(std::uint64_t id) {
  running_calls().begin(id);
  id_ = id;
}

ConcurrentCall::~ConcurrentCall() {
  if (id_ != 0) running_calls().end(id_);
}

ConcurrentCall::ConcurrentCall(ConcurrentCall&& other) noexcept : id_(std::exchange(other.id_, 0)) {}

ConcurrentCall& ConcurrentCall::operator=(ConcurrentCall&& other) noexcept {
  std::swap(id_, other.id_);
  return *this;
}

void ConcurrentCall::wait_for_end(std::uint64_t id) {
  running_calls().wait_for_others(id);
}

}  // namespace detail
}  // namespace tzc
