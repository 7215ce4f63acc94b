// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/direct_queue.h"

#include <tzc/direct_dispatch.h>

#include <vector>

#include "roscpp/worker.h"

namespace tzc {
namespace {

thread_local bool reads_directly = false;
thread_local std::vector<ros::CallbackInterfacePtr> pending;

class DirectQueue : public ros::CallbackQueueInterface {
 public:
  void addCallback(const ros::CallbackInterfacePtr& callback, std::uint64_t) override {
    if (reads_directly)
      pending.push_back(callback);
    else
      others_.post([callback] { callback->call(); });
  }
  /// Nothing to wait for: roscpp clears the subscription's own queue first, and a callback on an empty queue does
  /// nothing.
  void removeByID(std::uint64_t) override {}

 private:
  Worker others_;  ///< for messages that come over TCPROS or inside the process
};

}  // namespace

DirectReaderScope::DirectReaderScope() { reads_directly = true; }
DirectReaderScope::~DirectReaderScope() { reads_directly = false; }

void run_direct_callbacks() {
  std::vector<ros::CallbackInterfacePtr> callbacks;
  callbacks.swap(pending);
  for (const ros::CallbackInterfacePtr& callback : callbacks) callback->call();
}

ros::CallbackQueueInterface* direct_dispatch_queue() {
  static auto* const queue = new DirectQueue;  // outlives every static that may still unsubscribe
  return queue;
}

}  // namespace tzc
