// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/spin/heard_queue.h"

#include <ros/init.h>
#include <tzc/shared_reading.h>

#include <utility>

#include "roscpp/roscpp_version.h"
#include "roscpp/subscribe/fault_ready_callback.h"

namespace ros {
// What ros::getGlobalCallbackQueue() points to: roscpp's library exports it, and no header declares it. Null address: the
// roscpp of this process has none.
extern __attribute__((weak)) CallbackQueuePtr g_global_queue;
}  // namespace ros

namespace tzc {
namespace detail {
namespace {

thread_local HeardQueue* read_for = nullptr;
thread_local void (*left_call)() = nullptr;

// ros::init() makes a global queue only if there is none. It can run as soon as main() does, so this queue has to be there
// when the library is loaded, after roscpp, on which it depends.
const bool is_installed = [] {
  if (&ros::g_global_queue == nullptr || !is_roscpp_known_so_early()) return false;
  if (!ros::g_global_queue) ros::g_global_queue.reset(new HeardQueue);
  return true;
}();

}  // namespace

void HeardQueue::addCallback(const ros::CallbackInterfacePtr& callback, std::uint64_t removal_id) {
  ros::CallbackQueue::addCallback(fault_ready(callback), removal_id);
  channel::wake_idle_reader();
  // A thread counts itself before it looks for callbacks: either it has seen this one, or it is seen here.
  if (idle_threads_ == 0 || is_the_guests()) return;
  {
    const std::lock_guard<std::mutex> lock(idle_mutex_);  // it has looked, and sleeps by now
  }
  idle_.notify_one();
}

// The guest leaves when it sees a callback, says so, and takes one. As long as it has not said so, it is going to.
bool HeardQueue::is_the_guests() {
  const boost::mutex::scoped_lock lock(mutex_);
  return has_guest_ && !guest_has_call_ && callbacks_.size() <= 1;
}

void HeardQueue::wait(std::chrono::milliseconds most) {
  if (!wants_caller() && !wait_as_guest(most)) wait_for_turn(most);
  if (left_call != nullptr) std::exchange(left_call, nullptr)();
}

HeardQueue* HeardQueue::of_guest() {
  return read_for;
}

// In one step for threads that add a callback: it is there, or they see that the guest has something else to call.
bool HeardQueue::leave_call(void (*call)()) {
  const boost::mutex::scoped_lock lock(mutex_);
  if (!callbacks_.empty() || !enabled_ || guest_has_call_) return false;
  guest_has_call_ = true;
  left_call = call;
  return true;
}

bool HeardQueue::wait_as_guest(std::chrono::milliseconds most) {
  const std::unique_lock<std::mutex> guest(guest_, std::try_to_lock);
  if (!guest.owns_lock()) return false;
  has_guest_ = true;
  read_for = this;
  const bool has_read =
      channel::read_while_idle(most, [this] { return left_call != nullptr || wants_caller(); });
  read_for = nullptr;
  has_guest_ = false;
  const boost::mutex::scoped_lock lock(mutex_);
  guest_has_call_ = false;
  return has_read;
}

void HeardQueue::wait_for_turn(std::chrono::milliseconds most) {
  std::unique_lock<std::mutex> lock(idle_mutex_);
  ++idle_threads_;
  if (!wants_caller()) idle_.wait_for(lock, most);
  --idle_threads_;
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
