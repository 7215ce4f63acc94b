// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/worker.h"

#include <pthread.h>
#include <signal.h>

namespace tzc {
namespace {

/// Signals belong to the user's threads, as with roscpp's own.
void block_signals() {
  sigset_t all;
  sigfillset(&all);
  pthread_sigmask(SIG_BLOCK, &all, nullptr);
}

}  // namespace

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
  if (!thread_.joinable()) thread_ = std::thread([this] { run(); });
  wake_.notify_all();
}

void Worker::run() {
  block_signals();
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
      job();
      job = nullptr;  // what it captured may take locks when it dies
      lock.lock();
    }
  }
}

void WorkerQueue::addCallback(const ros::CallbackInterfacePtr& callback, std::uint64_t owner) {
  (void)owner;
  worker_.post([callback] { callback->call(); });
}

}  // namespace tzc
