// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace tzc {
namespace detail {

/// The id of a callback in callback queues: the address of what roscpp knows of it (Subscription::callbacks_).
template <class CallbackInfoPtr>
std::uint64_t removal_id(const CallbackInfoPtr& callback) {
  return reinterpret_cast<std::uintptr_t>(callback.get());
}

/// A direct call of a callback that several threads may be in at once (ros::SubscribeOptions::allow_concurrent_callbacks): no mutex of
/// roscpp's tells who unsubscribes that it runs. Begins and ends on one thread.
class ConcurrentCall {
 public:
  ConcurrentCall() = default;  ///< of no callback
  explicit ConcurrentCall(std::uint64_t id);
  ~ConcurrentCall();
  ConcurrentCall(ConcurrentCall&& other) noexcept;
  ConcurrentCall& operator=(ConcurrentCall&& other) noexcept;

  /// Waits until no other thread is in a call of this callback, but for those that wait here themselves.
  static void wait_for_end(std::uint64_t id);

 private:
  std::uint64_t id_ = 0;
};

}  // namespace detail
}  // namespace tzc
