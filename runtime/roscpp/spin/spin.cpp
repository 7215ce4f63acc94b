// SPDX-License-Identifier: BSD-3-Clause
#include <ros/init.h>
#include <ros/node_handle.h>
#include <tzc/spin.h>

#include "roscpp/spin/heard_queue.h"
#include "roscpp/spin/spinner_monitor.h"
#include "roscpp/spin/spinner_threads.h"

namespace tzc {

void spin() {
  detail::HeardQueue* const queue = detail::HeardQueue::global();
  if (queue == nullptr) return ros::spin();
  const detail::SpinsAlone alone(detail::spinner_monitor());
  const ros::NodeHandle node;
  while (node.ok()) {
    queue->wait(detail::kMostIdle);
    queue->callAvailable();
  }
}

AsyncSpinner::AsyncSpinner(std::uint32_t thread_count, ros::CallbackQueue* queue) {
  detail::HeardQueue* const global = detail::HeardQueue::global();
  if (global != nullptr && (queue == nullptr || queue == global))
    threads_ = std::make_shared<detail::SpinnerThreads>(thread_count, *global);
  else
    stock_ = std::make_shared<ros::AsyncSpinner>(thread_count, queue);
}

bool AsyncSpinner::canStart() {
  return threads_ || stock_->canStart();
}

void AsyncSpinner::start() {
  if (threads_)
    threads_->start();
  else
    stock_->start();
}

void AsyncSpinner::stop() {
  if (threads_)
    threads_->stop();
  else
    stock_->stop();
}

void MultiThreadedSpinner::spin(ros::CallbackQueue* queue) {
  AsyncSpinner spinner(thread_count_, queue);
  spinner.start();
  ros::waitForShutdown();
}

}  // namespace tzc
