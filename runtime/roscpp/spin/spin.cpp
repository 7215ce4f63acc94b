// SPDX-License-Identifier: BSD-3-Clause
#include <ros/init.h>
#include <ros/node_handle.h>
#include <tzc/shared_reading.h>
#include <tzc/spin.h>

#include <chrono>

#include "roscpp/spin/heard_queue.h"

namespace tzc {
namespace {

// ros::spin() looks this often whether the node is to end.
constexpr std::chrono::milliseconds kMostIdle(100);

void wait_for_callbacks(detail::HeardQueue& queue) {
  const auto wanted = [&queue] { return queue.wants_caller(); };
  if (!channel::read_while_idle(kMostIdle, wanted))
    queue.callAvailable(ros::WallDuration(std::chrono::duration<double>(kMostIdle).count()));
}

}  // namespace

void spin() {
  detail::HeardQueue* const queue = detail::HeardQueue::global();
  if (queue == nullptr) return ros::spin();
  const ros::NodeHandle node;
  while (node.ok()) {
    wait_for_callbacks(*queue);
    queue->callAvailable();
  }
}

}  // namespace tzc
