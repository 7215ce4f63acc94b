// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/spin/heard_queue.h"

#include <ros/init.h>
#include <tzc/shared_reading.h>

namespace ros {
// What ros::getGlobalCallbackQueue() points to: roscpp's library exports it, and no header declares it. Null address: the
// roscpp of this process has none.
extern __attribute__((weak)) CallbackQueuePtr g_global_queue;
}  // namespace ros

namespace tzc {
namespace detail {
namespace {

// ros::init() makes a global queue only if there is none. It can run as soon as main() does, so this queue has to be there
// when the library is loaded, after roscpp, on which it depends.
const bool is_installed = [] {
  if (&ros::g_global_queue == nullptr) return false;
  if (!ros::g_global_queue) ros::g_global_queue.reset(new HeardQueue);
  return true;
}();

}  // namespace

void HeardQueue::addCallback(const ros::CallbackInterfacePtr& callback, std::uint64_t removal_id) {
  ros::CallbackQueue::addCallback(callback, removal_id);
  channel::wake_idle_reader();
}

// Not isEmpty(), which counts callbacks that other threads are in.
bool HeardQueue::wants_caller() {
  const boost::mutex::scoped_lock lock(mutex_);
  return !callbacks_.empty() || !enabled_;
}

HeardQueue* HeardQueue::global() {
  return is_installed ? dynamic_cast<HeardQueue*>(ros::getGlobalCallbackQueue()) : nullptr;
}

}  // namespace detail
}  // namespace tzc
