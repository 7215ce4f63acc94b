// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/subscribe/direct_queue.h"

#include <ros/init.h>
#include <ros/subscription_queue.h>
#include <tzc/direct_dispatch.h>

#include <chrono>
#include <thread>
#include <vector>

#include "channel/fault_signals.h"
#include "roscpp/roscpp_access.h"
#include "roscpp/roscpp_version.h"
#include "roscpp/worker.h"
#include "sync_point/sync_point.h"

namespace tzc {
namespace detail {
namespace {

thread_local bool reads_directly = false;
thread_local std::vector<ros::CallbackInterfacePtr> pending;

/// For a roscpp whose queues' mutexes cannot be reached.
void call_when_free(const ros::CallbackInterfacePtr& callback) {
  constexpr std::chrono::milliseconds pause(1);
  while (callback->call() == ros::CallbackInterface::TryAgain) std::this_thread::sleep_for(pause);
}

/// A callback of the same subscription may be running on another publisher's thread. roscpp's queue would try
/// again later; this queue has no later, so it waits for the callback's end.
void call(const ros::CallbackInterfacePtr& callback) {
  if (ros::isShuttingDown())
    return;  // as roscpp's queue; whoever ends the subscription waits for one that has begun
  channel::keep_watching_write_faults();
  if (callback->call() != ros::CallbackInterface::TryAgain) return;
  sync_point("direct: waits for a callback");
  const auto queue = boost::dynamic_pointer_cast<ros::SubscriptionQueue>(callback);
  if (!queue) return;
  if (!is_roscpp_known()) return call_when_free(callback);
  const boost::recursive_mutex::scoped_lock lock(roscpp_access::callback_mutex_(*queue));
  callback->call();
}

/// An exception of the user's callback ends the process, as on every other thread that calls one.
void call_or_end(const ros::CallbackInterfacePtr& callback) noexcept {
  call(callback);
}

class DirectQueue : public ros::CallbackQueueInterface {
 public:
  void addCallback(const ros::CallbackInterfacePtr& callback, std::uint64_t) override {
    if (reads_directly)
      pending.push_back(callback);
    else
      others_.post([callback] { call_or_end(callback); });
  }
  /// Nothing to wait for: roscpp clears the subscription's own queue first, and a callback on an empty queue
  /// does nothing.
  void removeByID(std::uint64_t) override {}

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
  std::vector<ros::CallbackInterfacePtr> callbacks;
  callbacks.swap(pending);
  for (const ros::CallbackInterfacePtr& callback : callbacks) call_or_end(callback);
}

}  // namespace detail

ros::CallbackQueueInterface* direct_dispatch_queue() {
  static auto* const queue = new detail::DirectQueue;  // outlives every static that may still unsubscribe
  return queue;
}

}  // namespace tzc
