// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/callback_queue.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <mutex>

namespace tzc {
namespace detail {

/// roscpp's callback queue for threads that read shared messages while they wait for callbacks (tzc/shared_reading.h).
///
/// One idle thread is the *guest*, which reads; further ones sleep. A callback wakes the guest, or, if there is none or it has
/// one to call already, another idle thread; what the guest itself adds wakes nobody.
class HeardQueue final : public ros::CallbackQueue {
 public:
  void addCallback(const ros::CallbackInterfacePtr& callback, std::uint64_t removal_id) override;

  /// Waits until a callback is there, for so long at most. May return for no reason. Any number of threads.
  void wait(std::chrono::milliseconds most);

  /// The global queue of this process, if it is of this class. Null: something set it before this library was loaded.
  static HeardQueue* global();

 private:
  bool wants_caller();
  bool wait_as_guest(std::chrono::milliseconds most);
  void wait_for_turn(std::chrono::milliseconds most);
  bool is_the_guests();

  std::mutex guest_;  ///< held by the one that is there
  std::atomic<bool> has_guest_{false};
  std::mutex idle_mutex_;
  std::condition_variable idle_;
  std::atomic<unsigned> idle_threads_{0};  ///< besides the guest
};

}  // namespace detail
}  // namespace tzc
