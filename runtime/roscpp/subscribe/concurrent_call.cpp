// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/subscribe/concurrent_call.h"

#include <algorithm>
#include <condition_variable>
#include <map>
#include <mutex>
#include <utility>
#include <vector>

namespace tzc {
namespace detail {
namespace {

/// How many calls run, by callback. Thread-safe.
class RunningCalls {
 public:
  void begin(std::uint64_t id) {
    const std::lock_guard<std::mutex> lock(mutex_);
    ++calls_[id];
  }
  void end(std::uint64_t id) {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto ended = calls_.find(id);
    if (--ended->second == 0) calls_.erase(ended);
    changed_.notify_all();
  }
  /// Waits for all but so many, which are the calling thread's and count as ended meanwhile: two that wait would wait for each other.
  void wait_for_others(std::uint64_t id, int own) {
    std::unique_lock<std::mutex> lock(mutex_);
    if (own != 0) calls_[id] -= own;
    changed_.notify_all();
    changed_.wait(lock, [&] { return is_over(id); });
    if (own != 0) calls_[id] += own;
  }

 private:
  bool is_over(std::uint64_t id) const {
    const auto found = calls_.find(id);
    return found == calls_.end() || found->second == 0;
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  std::map<std::uint64_t, int> calls_;
};

RunningCalls& running_calls() {
  static auto* const instance = new RunningCalls;  // outlives every static that may still unsubscribe
  return *instance;
}

thread_local std::vector<std::uint64_t> of_this_thread;

}  // namespace

ConcurrentCall::ConcurrentCall(std::uint64_t id) {
  of_this_thread.reserve(of_this_thread.size() + 1);
  running_calls().begin(id);
  of_this_thread.push_back(id);
  id_ = id;
}

ConcurrentCall::~ConcurrentCall() {
  if (id_ == 0) return;
  of_this_thread.erase(std::find(of_this_thread.begin(), of_this_thread.end(), id_));
  running_calls().end(id_);
}

ConcurrentCall::ConcurrentCall(ConcurrentCall&& other) noexcept : id_(std::exchange(other.id_, 0)) {}

ConcurrentCall& ConcurrentCall::operator=(ConcurrentCall&& other) noexcept {
  std::swap(id_, other.id_);
  return *this;
}

void ConcurrentCall::wait_for_end(std::uint64_t id) {
  const auto own = std::count(of_this_thread.begin(), of_this_thread.end(), id);
  running_calls().wait_for_others(id, static_cast<int>(own));
}

}  // namespace detail
}  // namespace tzc
