// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/subscribe/direct_queue.h"

#include <ros/init.h>
#include <ros/subscription_queue.h>
#include <tzc/direct_dispatch.h>

#include <chrono>
#include <cstdint>
#include <thread>
#include <vector>

#include "channel/fault_signals.h"
#include "roscpp/roscpp_access.h"
#include "roscpp/roscpp_version.h"
#include "roscpp/subscribe/concurrent_call.h"
#include "roscpp/worker.h"
#include "sync_point/sync_point.h"

namespace tzc {
namespace detail {
namespace {

struct Queued {
  ros::CallbackInterfacePtr callback;
  std::uint64_t removal_id;
};

thread_local bool reads_directly = false;
thread_local std::vector<Queued> pending;

/// For a roscpp whose queues' mutexes cannot be reached.
void call_when_free(const ros::CallbackInterfacePtr& callback) {
  constexpr std::chrono::milliseconds pause(1);
  while (callback->call() == ros::CallbackInterface::TryAgain) std::this_thread::sleep_for(pause);
}

/// A callback of the same subscription may be running on another publisher's thread. roscpp's queue would try
/// again later; this queue has no later, so it waits for the callback's end.
void call_in_turn(const ros::CallbackInterfacePtr& callback) {
  if (callback->call() != ros::CallbackInterface::TryAgain) return;
  sync_point("direct: waits for a callback");
  const auto queue = boost::dynamic_pointer_cast<ros::SubscriptionQueue>(callback);
  if (!queue) return;
  if (!is_roscpp_known()) return call_when_free(callback);
  const boost::recursive_mutex::scoped_lock lock(roscpp_access::callback_mutex_(*queue));
  callback->call();
}

/// One that has no turn. Who unsubscribes removes its messages first: either they are gone, or this call is waited for.
ConcurrentCall concurrent_call(const Queued& queued) {
  auto* const queue = dynamic_cast<ros::SubscriptionQueue*>(queued.callback.get());
  const bool is_concurrent =
      queue != nullptr && is_roscpp_known() && roscpp_access::allow_concurrent_callbacks_(*queue);
  return is_concurrent ? ConcurrentCall(queued.removal_id) : ConcurrentCall();
}

/// An exception of the user's callback ends the process, as on every other thread that calls one.
void call_or_end(const Queued& queued) noexcept {
  const ConcurrentCall concurrent = concurrent_call(queued);
  if (ros::isShuttingDown())
    return;  // as roscpp's queue; whoever ends the subscription waits for one that has begun
  channel::keep_watching_write_faults();
  call_in_turn(queued.callback);
}

class DirectQueue : public ros::CallbackQueueInterface {
 public:
  void addCallback(const ros::CallbackInterfacePtr& callback, std::uint64_t removal_id) override {
    const Queued queued{callback, removal_id};
    if (reads_directly)
      pending.push_back(queued);
    else
      others_.post([queued] { call_or_end(queued); });
  }
  /// roscpp clears the subscription's own queue first, under the mutex that a running callback has, and a callback on an empty queue does
  /// nothing. What remains is a callback that has no turn.
  void removeByID(std::uint64_t removal_id) override { ConcurrentCall::wait_for_end(removal_id); }

 private:
  Worker others_;  ///< for messages that come over TCPROS or inside the process
};

}  // namespace

DirectReaderScope::DirectReaderScope() {
  reads_directly = true;
}
DirectReaderScope::~DirectReaderScope() {
  reads_directly = false;
}

void run_direct_callbacks() {
  std::vector<Queued> callbacks;
  callbacks.swap(pending);
  for (const Queued& queued : callbacks) call_or_end(queued);
}

}  // namespace detail

ros::CallbackQueueInterface* direct_dispatch_queue() {
  static auto* const queue = new detail::DirectQueue;  // outlives every static that may still unsubscribe
  return queue;
}

}  // namespace tzc
