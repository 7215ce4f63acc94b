// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/spin/spinner_threads.h"

#include <pthread.h>

#include <algorithm>
#include <system_error>

#include "channel/fault_signals.h"
#include "roscpp/spin/spinner_monitor.h"

namespace tzc {
namespace detail {

SpinnerThreads::SpinnerThreads(std::uint32_t count, HeardQueue& queue)
    : count_(count != 0 ? count : std::max(1U, std::thread::hardware_concurrency())), queue_(queue) {}

void SpinnerThreads::start() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (goes_on_) return;
  spinner_monitor().begin_with_threads();
  goes_on_ = true;
  try {
    while (threads_.size() < count_) threads_.emplace_back([this] { run(); });
  } catch (const std::system_error&) {
    end();
    throw;
  }
}

void SpinnerThreads::stop() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (goes_on_) end();
}

void SpinnerThreads::end() {
  goes_on_ = false;
  for (std::thread& thread : threads_) thread.join();
  threads_.clear();
  spinner_monitor().end_with_threads();
}

// As roscpp: one thread calls what is there in one go, several take turns.
void SpinnerThreads::run() {
  const sigset_t others = channel::all_but_faults();
  pthread_sigmask(SIG_BLOCK, &others, nullptr);
  while (goes_on_ && node_.ok()) {
    queue_.wait(kMostIdle);
    if (count_ == 1)
      queue_.callAvailable();
    else
      queue_.callOne();
  }
}

}  // namespace detail
}  // namespace tzc
