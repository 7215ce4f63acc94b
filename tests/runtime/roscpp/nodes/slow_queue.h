// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/callback_queue_interface.h>

#include <atomic>
#include <cstdint>
#include <deque>
#include <functional>
#include <mutex>
#include <utility>

namespace tzc_test {

/// A callback queue that holds the thread that brings its first message.
class SlowQueue : public ros::CallbackQueueInterface {
 public:
  explicit SlowQueue(std::function<void()> hold) : hold_(std::move(hold)) {}

  void addCallback(const ros::CallbackInterfacePtr& callback, std::uint64_t) override {
    if (first_.exchange(false)) hold_();
    const std::lock_guard<std::mutex> lock(mutex_);
    callbacks_.push_back(callback);
  }
  void removeByID(std::uint64_t) override {}
  void call_available() {
    for (ros::CallbackInterfacePtr callback = take(); callback; callback = take()) callback->call();
  }

 private:
  ros::CallbackInterfacePtr take() {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (callbacks_.empty()) return ros::CallbackInterfacePtr();
    const ros::CallbackInterfacePtr callback = callbacks_.front();
    callbacks_.pop_front();
    return callback;
  }

  const std::function<void()> hold_;
  std::atomic<bool> first_{true};
  std::mutex mutex_;
  std::deque<ros::CallbackInterfacePtr> callbacks_;
};

}  // namespace tzc_test
