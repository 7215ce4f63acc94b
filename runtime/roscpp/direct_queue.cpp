// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/direct_queue.h"

#include <ros/subscription_queue.h>
#include <tzc/direct_dispatch.h>

#include <vector>

#include "posix/step.h"
#include "roscpp/roscpp_access.h"
#include "roscpp/worker.h"

namespace tzc {
namespace {

thread_local bool reads_directly = false;
thread_local std::vector<ros::CallbackInterfacePtr> pending;

/// A callback of the same subscription may be running on another publisher's thread. roscpp's queue would try
/// again later; here nobody would, so this one waits for its end.
void call(const ros::CallbackInterfacePtr& callback) {
  if (callback->call() != ros::CallbackInterface::TryAgain) return;
  posix::step("direct: waits for a callback");
  const auto queue = boost::dynamic_pointer_cast<ros::SubscriptionQueue>(callback);
  if (!queue) return;
  const boost::recursive_mutex::scoped_lock lock(roscpp_access::callback_mutex_(*queue));
  callback->call();
}

class DirectQueue : public ros::CallbackQueueInterface {
 public:
  void addCallback(const ros::CallbackInterfacePtr& callback, std::uint64_t) override {
    if (reads_directly)
      pending.push_back(callback);
    else
      others_.post([callback] { call(callback); });
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
  for (const ros::CallbackInterfacePtr& callback : callbacks) call(callback);
}

ros::CallbackQueueInterface* direct_dispatch_queue() {
  static auto* const queue = new DirectQueue;  // outlives every static that may still unsubscribe
  return queue;
}

}  // namespace tzc
