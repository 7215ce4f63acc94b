// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/worker.h"

#include "roscpp/transport_thread.h"

namespace tzc {
namespace detail {

Worker::~Worker() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    stopping_ = true;
  }
  wake_.notify_all();
  if (!thread_.joinable()) return;
  if (thread_.get_id() == std::this_thread::get_id())
    thread_.detach();
  else
    thread_.join();
}

void Worker::post(Job job, std::chrono::microseconds delay) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (stopping_) return;
  jobs_.emplace(Clock::now() + delay, std::move(job));
  // Without a thread the jobs wait until a later post() can start one; meanwhile their connections stay on
  // TCPROS.
  if (!thread_.joinable()) start_transport_thread(thread_, [this] { run(); });
  wake_.notify_all();
}

void Worker::run() {
  std::unique_lock<std::mutex> lock(mutex_);
  while (!stopping_) {
    if (jobs_.empty()) {
      wake_.wait(lock);
    } else if (const Clock::time_point due = jobs_.begin()->first; due > Clock::now()) {
      wake_.wait_until(lock, due);
    } else {
      Job job = std::move(jobs_.begin()->second);
      jobs_.erase(jobs_.begin());
      lock.unlock();
      run_job(std::move(job));
      lock.lock();
    }
  }
}

void WorkerQueue::addCallback(const ros::CallbackInterfacePtr& callback, std::uint64_t owner) {
  (void)owner;
  worker_.post([callback] { callback->call(); });
}

}  // namespace detail
}  // namespace tzc
