// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/callback_queue.h>

namespace tzc {
namespace detail {

/// roscpp's callback queue, which also wakes the thread that waits for its callbacks while it reads shared messages
/// (tzc/shared_reading.h).
class HeardQueue final : public ros::CallbackQueue {
 public:
  void addCallback(const ros::CallbackInterfacePtr& callback, std::uint64_t removal_id) override;

  /// Whether callAvailable() has something to do, or would return at once.
  bool wants_caller();

  /// The global queue of this process, if it is of this class. Null: something set it before this library was loaded.
  static HeardQueue* global();
};

}  // namespace detail
}  // namespace tzc
