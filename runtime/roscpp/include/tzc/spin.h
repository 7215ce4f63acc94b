// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/spinner.h>

#include <cstdint>
#include <memory>

// roscpp's spinners with one wake-up for a shared message instead of two: a spinning thread that has nothing else to do reads the
// shared messages of this node, and is woken by their publishers. Callbacks, their threads and order, queue sizes, timers, services,
// messages over TCPROS and shutdown are as with roscpp's; while no thread is idle, the library's thread reads. They are roscpp's
// spinners where they have to be: when this library was loaded after ros::init(), and for queues other than the global one.
// As with roscpp's, spin() on two threads, or beside an AsyncSpinner or MultiThreadedSpinner, is a std::runtime_error; only, those of
// roscpp and these do not see each other.

namespace tzc {

namespace detail {
class SpinnerThreads;
}  // namespace detail

/// ros::spin(). Throws std::runtime_error when another spinner of this header calls the global queue's callbacks.
void spin();

/// ros::AsyncSpinner: calls back on threads of its own from start() on, until stop(), the node's end, or the end of its last copy.
class AsyncSpinner {
 public:
  /// @param thread_count 0: as many as there are processors
  /// @param queue null: the global queue
  explicit AsyncSpinner(std::uint32_t thread_count, ros::CallbackQueue* queue = nullptr);

  /// As roscpp's, for a queue of the program's own; otherwise true.
  bool canStart();
  /// Does nothing when it runs already. Throws std::system_error when there are no threads left, std::runtime_error while
  /// tzc::spin() runs.
  void start();
  /// Waits for the callbacks that run. Not to be called by one of them.
  void stop();

 private:
  std::shared_ptr<detail::SpinnerThreads> threads_;  ///< null: it is a stock one
  std::shared_ptr<ros::AsyncSpinner> stock_;
};

/// ros::MultiThreadedSpinner.
class MultiThreadedSpinner : public ros::Spinner {
 public:
  /// @param thread_count 0: as many as there are processors
  explicit MultiThreadedSpinner(std::uint32_t thread_count = 0) : thread_count_(thread_count) {}
  /// Returns when the node ends.
  void spin(ros::CallbackQueue* queue = nullptr) override;

 private:
  const std::uint32_t thread_count_;
};

}  // namespace tzc
