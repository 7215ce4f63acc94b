// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mutex>
#include <thread>

namespace tzc {
namespace detail {

/// Who calls the callbacks of a queue: one thread, in their order, or spinners with threads of their own, any number of them; never
/// both. The rule of roscpp's spinners, whose own monitor its library hides. Thread-safe.
class SpinnerMonitor {
 public:
  /// For the calling thread, alone. It may do so again in a callback. Throws std::runtime_error, after a fatal line in the log, where
  /// others call already.
  void begin_alone();
  void end_alone();
  /// For a spinner with threads of its own. Throws likewise, where a thread calls alone.
  void begin_with_threads();
  void end_with_threads();

 private:
  std::mutex mutex_;
  std::thread::id alone_;  ///< none: no thread
  unsigned depth_ = 0;     ///< of that thread
  unsigned with_threads_ = 0;
};

/// That of the global queue.
SpinnerMonitor& spinner_monitor();

/// A thread that calls alone, until its end, also by an exception of a callback.
class SpinsAlone {
 public:
  explicit SpinsAlone(SpinnerMonitor& monitor) : monitor_(monitor) { monitor_.begin_alone(); }
  ~SpinsAlone() { monitor_.end_alone(); }
  SpinsAlone(const SpinsAlone&) = delete;
  SpinsAlone& operator=(const SpinsAlone&) = delete;

 private:
  SpinnerMonitor& monitor_;
};

}  // namespace detail
}  // namespace tzc
