// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/callback_queue_interface.h>

#include <atomic>
#include <chrono>
#include <cstdint>

#include "race.h"

namespace tzc_test {

/// Dies slowly, so that whoever uses it then is seen.
class DyingQueue : public ros::CallbackQueueInterface {
 public:
  ~DyingQueue() override {
    is_dead_ = true;
    gate().wait_for({"never"}, std::chrono::milliseconds(1000));
    print_event("used when dead", is_used_);
  }
  void addCallback(const ros::CallbackInterfacePtr&, std::uint64_t) override { is_used_ = is_dead_.load(); }
  void removeByID(std::uint64_t) override {}

 private:
  std::atomic<bool> is_dead_{false}, is_used_{false};
};

}  // namespace tzc_test
