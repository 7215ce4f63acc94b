// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/callback_queue_interface.h>

#include <chrono>
#include <functional>
#include <map>
#include <mutex>
#include <thread>

#include "roscpp/monotonic_condition.h"

namespace tzc {
namespace detail {

/// A thread of the transport, for connect callbacks, moves and clean-up: roscpp's threads hold locks with
/// which these would deadlock or delay every topic. Jobs run one at a time, in order of their due time.
/// Thread-safe. The thread starts with the first job; jobs that are not due when the worker ends do not run.
class Worker {
 public:
  using Job = std::function<void()>;

  Worker() = default;
  ~Worker();
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  void post(Job job, std::chrono::microseconds delay = std::chrono::microseconds(0));

 private:
  using Clock = std::chrono::steady_clock;
  void run();

  std::mutex mutex_;
  MonotonicCondition wake_;
  std::multimap<Clock::time_point, Job> jobs_;
  bool stopping_ = false;
  std::thread thread_;
};

/// Lets roscpp queue its callbacks on the worker.
class WorkerQueue : public ros::CallbackQueueInterface {
 public:
  explicit WorkerQueue(Worker& worker) : worker_(worker) {}
  void addCallback(const ros::CallbackInterfacePtr& callback, std::uint64_t owner) override;
  /// Nothing to do: callbacks given to this queue carry a tracked object and turn invalid with it.
  void removeByID(std::uint64_t owner) override { (void)owner; }

 private:
  Worker& worker_;
};

}  // namespace detail
}  // namespace tzc
