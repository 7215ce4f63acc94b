// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/subscribe/fault_ready_queue.h"

#include <ros/callback_queue_interface.h>
#include <tzc/direct_dispatch.h>

#include <boost/make_shared.hpp>
#include <map>
#include <memory>
#include <mutex>
#include <typeinfo>

#include "channel/fault_signals.h"
#include "roscpp/roscpp_access.h"
#include "roscpp/subscribe/writing_callback.h"

namespace tzc {
namespace detail {
namespace {

namespace access = roscpp_access;

class FaultReadyCallback final : public ros::CallbackInterface {
 public:
  explicit FaultReadyCallback(ros::CallbackInterfacePtr callback) : callback_(std::move(callback)) {}
  CallResult call() override {
    channel::keep_watching_write_faults();
    return callback_->call();
  }
  bool ready() override { return callback_->ready(); }

 private:
  const ros::CallbackInterfacePtr callback_;
};

/// Stands for another queue, to which it adds callbacks that get ready for faults first.
class FaultReadyQueue final : public ros::CallbackQueueInterface {
 public:
  explicit FaultReadyQueue(ros::CallbackQueueInterface& queue) : queue_(queue) {}
  void addCallback(const ros::CallbackInterfacePtr& callback, std::uint64_t removal_id) override {
    queue_.addCallback(boost::make_shared<FaultReadyCallback>(callback), removal_id);
  }
  void removeByID(std::uint64_t removal_id) override { queue_.removeByID(removal_id); }
  bool stands_for(const ros::CallbackQueueInterface& queue) const { return &queue_ == &queue; }

 private:
  ros::CallbackQueueInterface& queue_;
};

/// One for each queue, and never destroyed: roscpp may remove a callback from it as long as its subscription lives. A queue
/// at the address of one that is gone is served as well.
FaultReadyQueue* stand_in_for(ros::CallbackQueueInterface& queue) {
  static auto& stand_ins = *new std::map<ros::CallbackQueueInterface*, std::unique_ptr<FaultReadyQueue>>;
  static std::mutex mutex;
  const std::lock_guard<std::mutex> lock(mutex);
  std::unique_ptr<FaultReadyQueue>& stand_in = stand_ins[&queue];
  if (!stand_in) stand_in = std::make_unique<FaultReadyQueue>(queue);
  return stand_in.get();
}

}  // namespace

// The threads of the direct queue are TZC's.
bool make_ready_for_faults(ros::Subscription& subscription, const MessageCodec& codec) {
  bool has_writers = false;
  const boost::mutex::scoped_lock lock(access::callbacks_mutex_(subscription));
  for (const auto& callback : access::callbacks_(subscription)) {
    has_writers = has_writers || may_write(*callback->helper_, codec);
    ros::CallbackQueueInterface*& queue = callback->callback_queue_;
    if (queue == direct_dispatch_queue() || dynamic_cast<FaultReadyQueue*>(queue) != nullptr) continue;
    queue = stand_in_for(*queue);
  }
  return has_writers;
}

bool leads_to(const ros::CallbackQueueInterface& queue, const ros::CallbackQueueInterface& other) {
  if (&queue == &other) return true;
  return typeid(queue) == typeid(FaultReadyQueue) &&
         static_cast<const FaultReadyQueue&>(queue).stands_for(other);
}

}  // namespace detail
}  // namespace tzc
