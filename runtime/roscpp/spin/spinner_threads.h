// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>

#include <atomic>
#include <chrono>
#include <cstdint>
#include <mutex>
#include <thread>
#include <vector>

#include "roscpp/spin/heard_queue.h"

namespace tzc {
namespace detail {

/// roscpp's spinners look this often whether the node is to end.
constexpr std::chrono::milliseconds kMostIdle(100);

/// Threads that call the callbacks of the global queue, and read shared messages while they are idle. Thread-safe.
class SpinnerThreads {
 public:
  SpinnerThreads(std::uint32_t count, HeardQueue& queue);
  ~SpinnerThreads() { stop(); }

  void start();
  void stop();

 private:
  void run();
  void end();  ///< under mutex_

  const std::uint32_t count_;
  HeardQueue& queue_;
  const ros::NodeHandle node_;  ///< keeps the node alive, as roscpp's spinners do
  std::mutex mutex_;
  std::atomic<bool> goes_on_{false};
  std::vector<std::thread> threads_;
};

}  // namespace detail
}  // namespace tzc
