// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/subscribe/fault_ready_queue.h"

#include <ros/poll_manager.h>
#include <ros/topic_manager.h>
#include <tzc/direct_dispatch.h>

#include <boost/signals2/connection.hpp>
#include <boost/thread/lock_types.hpp>
#include <boost/thread/mutex.hpp>
#include <boost/weak_ptr.hpp>
#include <map>
#include <memory>
#include <mutex>
#include <new>
#include <typeinfo>
#include <unordered_set>

#include "roscpp/before_exit.h"
#include "roscpp/roscpp_access.h"
#include "roscpp/spin/heard_queue.h"
#include "roscpp/subscribe/fault_ready_callback.h"
#include "roscpp/subscribe/writing_callback.h"

namespace tzc {
namespace detail {
namespace {

namespace access = roscpp_access;

/// Stands for another queue, to which it adds callbacks that get ready for faults first.
class FaultReadyQueue final : public ros::CallbackQueueInterface {
 public:
  explicit FaultReadyQueue(ros::CallbackQueueInterface& queue) : queue_(queue) {}
  void addCallback(const ros::CallbackInterfacePtr& callback, std::uint64_t removal_id) override {
    queue_.addCallback(fault_ready(callback), removal_id);
  }
  void removeByID(std::uint64_t removal_id) override { queue_.removeByID(removal_id); }
  bool stands_for(const ros::CallbackQueueInterface& queue) const { return &queue_ == &queue; }

 private:
  ros::CallbackQueueInterface& queue_;
};

/// One for each queue, and never destroyed: roscpp may remove a callback from it as long as its subscription lives. A queue
/// at the address of one that is gone is served as well. Thread-safe.
class StandIns {
 public:
  FaultReadyQueue* of(ros::CallbackQueueInterface& queue) {
    const std::lock_guard<std::mutex> lock(mutex_);
    std::unique_ptr<FaultReadyQueue>& stand_in = by_queue_[&queue];
    if (!stand_in) stand_in = std::make_unique<FaultReadyQueue>(queue);
    all_.insert(stand_in.get());
    return stand_in.get();
  }
  bool has(const ros::CallbackQueueInterface* queue) {
    const std::lock_guard<std::mutex> lock(mutex_);
    return all_.count(queue) != 0;
  }

 private:
  std::mutex mutex_;
  std::map<ros::CallbackQueueInterface*, std::unique_ptr<FaultReadyQueue>> by_queue_;
  std::unordered_set<const ros::CallbackQueueInterface*> all_;
};

StandIns& stand_ins() {
  static auto* const instance = new StandIns;
  return *instance;
}

/// Leaves the queue itself alone: it may be gone, where the subscription gets no message.
bool is_known_to_be_ready(const ros::CallbackQueueInterface* queue) {
  return queue == HeardQueue::global() || queue == direct_dispatch_queue() || stand_ins().has(queue);
}

bool try_make_ready(ros::Subscription& subscription) {
  const boost::unique_lock<boost::mutex> lock(access::callbacks_mutex_(subscription), boost::try_to_lock);
  if (!lock.owns_lock()) return false;
  for (const auto& callback : access::callbacks_(subscription)) {
    ros::CallbackQueueInterface*& queue = callback->callback_queue_;
    if (!is_known_to_be_ready(queue)) queue = stand_ins().of(*queue);
  }
  return true;
}

bool try_make_all_ready(ros::TopicManager& topics) {
  const boost::unique_lock<boost::mutex> lock(access::subs_mutex_(topics), boost::try_to_lock);
  if (!lock.owns_lock()) return false;
  bool are_ready = true;
  for (const ros::SubscriptionPtr& subscription : access::subscriptions_(topics))
    are_ready = try_make_ready(*subscription) && are_ready;
  return are_ready;
}

void make_ready_in_a_round(ros::TopicManager& topics) {
  const BeforeExit step;  // roscpp's poll thread runs during exit(), too
  if (!step) return;
  try {
    try_make_all_ready(topics);
  } catch (const std::bad_alloc&) {
    return;  // another round makes them ready
  }
}

}  // namespace

ros::CallbackQueueInterface* fault_ready_queue(ros::CallbackQueueInterface& queue) {
  const std::type_info& type = typeid(queue);
  const bool is_ready =
      type == typeid(FaultReadyQueue) || type == typeid(HeardQueue) || &queue == direct_dispatch_queue();
  return is_ready ? &queue : stand_ins().of(queue);
}

bool make_ready_for_faults(ros::Subscription& subscription, const MessageCodec& codec) {
  bool has_writers = false;
  const boost::mutex::scoped_lock lock(access::callbacks_mutex_(subscription));
  for (const auto& callback : access::callbacks_(subscription)) {
    has_writers = has_writers || may_write(*callback->helper_, codec);
    callback->callback_queue_ = fault_ready_queue(*callback->callback_queue_);
  }
  return has_writers;
}

bool try_make_all_ready_for_faults() {
  return try_make_all_ready(*ros::TopicManager::instance());
}

// roscpp forgets its listeners when the node shuts down, also one that is started again. Its thread may run longer than the topics live.
void keep_all_ready_for_faults() {
  static auto& listener = *new boost::signals2::connection;
  static std::mutex mutex;
  const std::lock_guard<std::mutex> lock(mutex);
  if (listener.connected()) return;
  const boost::weak_ptr<ros::TopicManager> weak = ros::TopicManager::instance();
  listener = ros::PollManager::instance()->addPollThreadListener([weak] {
    if (const ros::TopicManagerPtr topics = weak.lock()) make_ready_in_a_round(*topics);
  });
}

bool leads_to(const ros::CallbackQueueInterface& queue, const ros::CallbackQueueInterface& other) {
  if (&queue == &other) return true;
  return typeid(queue) == typeid(FaultReadyQueue) &&
         static_cast<const FaultReadyQueue&>(queue).stands_for(other);
}

}  // namespace detail
}  // namespace tzc
