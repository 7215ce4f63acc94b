// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/spin/spinner_monitor.h"

#include <ros/console.h>

#include <stdexcept>
#include <string>

namespace tzc {
namespace detail {
namespace {

[[noreturn]] void refuse(const std::string& spinner, const std::string& other) {
  ROS_FATAL_STREAM(
      "TZC: " << spinner << " is refused: " << other
              << " calls the callbacks of this queue already, and they would run at once or out of "
                 "their order. End the other one first, or give one of them a queue of its own");
  throw std::runtime_error(spinner + ": there is already another spinner on this queue");
}

}  // namespace

void SpinnerMonitor::begin_alone() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    const std::thread::id caller = std::this_thread::get_id();
    if (with_threads_ == 0 && (depth_ == 0 || alone_ == caller)) {
      alone_ = caller;
      ++depth_;
      return;
    }
  }
  refuse("tzc::spin()", "a spinner with threads of its own, or spin() on another thread,");
}

void SpinnerMonitor::end_alone() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (--depth_ == 0) alone_ = std::thread::id();
}

void SpinnerMonitor::begin_with_threads() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (depth_ == 0) {
      ++with_threads_;
      return;
    }
  }
  refuse("tzc::AsyncSpinner", "tzc::spin()");
}

void SpinnerMonitor::end_with_threads() {
  const std::lock_guard<std::mutex> lock(mutex_);
  --with_threads_;
}

SpinnerMonitor& spinner_monitor() {
  static SpinnerMonitor of_global_queue;
  return of_global_queue;
}

}  // namespace detail
}  // namespace tzc
