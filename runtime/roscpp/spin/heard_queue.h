// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/callback_queue.h>

#include <atomic>
#include <chrono>
#include <cstdint>
#include <mutex>

#include "roscpp/monotonic_condition.h"

namespace tzc {
namespace detail {

/// roscpp's callback queue for threads that read shared messages while they wait for callbacks (tzc/shared_reading.h).
///
/// One idle thread is the *guest*, which reads; further ones sleep. A callback wakes the guest, or, if there is none or it has
/// one to call already, another idle thread; what the guest itself adds wakes nobody.
///
/// All callbacks are ready for faults (subscribe/fault_ready_callback.h), those of timers, services and plain subscriptions, too: they
/// may write to a shared message that another one has kept.
///
/// What reads on the guest's thread may leave it one call, which then need not go through this queue.
class HeardQueue final : public ros::CallbackQueue {
 public:
  void addCallback(const ros::CallbackInterfacePtr& callback, std::uint64_t removal_id) override;

  /// Waits until a callback is there, for so long at most, and makes the call that it was left as the guest, if any. May return
  /// for no reason. Any number of threads.
  void wait(std::chrono::milliseconds most);

  /// The queue for which the calling thread reads now, as its guest. Null: it does not.
  static HeardQueue* of_guest();
  /// On the guest's thread: it makes the call as soon as it has left the reading to the reader, before whatever comes into this
  /// queue from now on. False: something waits here already, the guest has a call, or the queue is disabled.
  bool leave_call(void (*call)());

  /// The global queue of this process, if it is of this class. Null: something set it before this library was loaded.
  static HeardQueue* global();

 private:
  bool wants_caller();
  bool wait_as_guest(std::chrono::milliseconds most);
  void wait_for_turn(std::chrono::milliseconds most);
  bool is_the_guests();

  std::mutex guest_;  ///< held by the one that is there
  std::atomic<bool> has_guest_{false};
  bool guest_has_call_ = false;  ///< under mutex_
  std::mutex idle_mutex_;
  MonotonicCondition idle_;
  std::atomic<unsigned> idle_threads_{0};  ///< besides the guest
};

}  // namespace detail
}  // namespace tzc
