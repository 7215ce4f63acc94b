// SPDX-License-Identifier: BSD-3-Clause
#include "channel/wait/service.h"

#include <algorithm>
#include <atomic>

#include "posix/fork_epoch.h"
#include "posix/thread.h"

namespace tzc {
namespace channel {
namespace {

std::atomic<Service*> running_service{nullptr};
std::mutex service_start_mutex;

}  // namespace

// A forked child starts a service of its own and leaves the parent's object alone: its locks may be in any
// state.
Expected<Service*> Service::instance() {
  Service* service = running_service.load(std::memory_order_acquire);
  if (service != nullptr && !posix::forked_since(service->epoch_)) return service;
  const std::lock_guard<std::mutex> lock(service_start_mutex);
  service = running_service.load(std::memory_order_acquire);
  if (service != nullptr && !posix::forked_since(service->epoch_)) return service;
  return start();
}

Expected<Service*> Service::start() {
  auto poller = posix::Poller::create();
  if (!poller) return poller.error();
  std::unique_ptr<Service> service(new Service(std::move(*poller)));
  const Status started = posix::start_small_thread("tzc-service", [raw = service.get()] { raw->run(); });
  if (!started) return started.error();
  running_service.store(service.get(), std::memory_order_release);
  return service.release();
}

Service::Service(std::unique_ptr<posix::Poller> poller)
    : poller_(std::move(poller)), epoch_(posix::fork_epoch()) {}

Expected<std::uint64_t> Service::add(int fd, bool readable, bool writable, std::shared_ptr<Watcher> watcher) {
  std::uint64_t key = 0;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    key = watchers_.add(std::move(watcher));
  }
  const Status watched = poller_->watch(fd, key, readable, writable);
  if (watched) return key;
  const std::lock_guard<std::mutex> lock(mutex_);
  watchers_.remove(key);
  return watched.error();
}

void Service::change(int fd, std::uint64_t key, bool readable, bool writable) {
  poller_->change(fd, key, readable, writable);
}

Status Service::watch(int fd, std::uint64_t key, bool readable, bool writable) {
  return poller_->watch(fd, key, readable, writable);
}

void Service::unwatch(int fd) {
  poller_->forget(fd);
}

void Service::set_deadline(std::uint64_t key, Clock::time_point when) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!watchers_.set_deadline(key, when)) return;  // the thread wakes up early enough
  }
  poller_->wake();
}

void Service::remove(int fd, std::uint64_t key) {
  forget(fd, key);
  synchronize();
}

void Service::forget(int fd, std::uint64_t key) {
  poller_->forget(fd);
  std::shared_ptr<Watcher> last;  // destroyed without the lock
  const std::lock_guard<std::mutex> lock(mutex_);
  last = watchers_.remove(key);
}

void Service::synchronize() {
  std::unique_lock<std::mutex> lock(mutex_);
  if (std::this_thread::get_id() == thread_id_) return;
  const std::uint64_t round = rounds_;
  round_ended_.wait(lock, [this, round] { return !in_round_ || rounds_ != round; });
}

void Service::run() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    thread_id_ = std::this_thread::get_id();
  }
  std::vector<posix::Poller::Event> events;
  for (;;) {
    poller_->wait(timeout_ms(), events);
    for (const auto& event : events) {
      if (const auto watcher = find(event.key)) watcher->on_event(event);
      end_round();
    }
    run_deadlines();
    if (called_.exchange(false)) run_calls();
  }
}

void Service::add_callee(std::weak_ptr<Callee> callee) {
  const std::lock_guard<std::mutex> lock(mutex_);
  callees_.erase(
      std::remove_if(callees_.begin(), callees_.end(), [](const auto& one) { return one.expired(); }),
      callees_.end());
  callees_.push_back(std::move(callee));
}

void Service::call_all() noexcept {
  called_.store(true);
  poller_->wake();
}

void Service::run_calls() {
  std::vector<std::weak_ptr<Callee>> callees;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    callees = callees_;
  }
  for (const std::weak_ptr<Callee>& one : callees) {
    if (const auto callee = one.lock()) callee->on_call();
  }
}

// Marks the round before it releases the lock: a thread that removes the watcher from now on waits for the
// call's end.
std::shared_ptr<Watcher> Service::find(std::uint64_t key) {
  const std::lock_guard<std::mutex> lock(mutex_);
  auto watcher = watchers_.find(key);
  if (watcher) in_round_ = true;
  return watcher;
}

void Service::end_round() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!in_round_) return;
  in_round_ = false;
  ++rounds_;
  round_ended_.notify_all();
}

void Service::run_deadlines() {
  const Clock::time_point now = Clock::now();
  while (const std::shared_ptr<Watcher> watcher = next_due(now)) {
    watcher->on_deadline();
    end_round();
  }
}

std::shared_ptr<Watcher> Service::next_due(Clock::time_point now) {
  const std::lock_guard<std::mutex> lock(mutex_);
  auto watcher = watchers_.take_due(now);
  if (watcher) in_round_ = true;
  return watcher;
}

int Service::timeout_ms() {
  const std::lock_guard<std::mutex> lock(mutex_);
  const Clock::time_point first = watchers_.first_deadline();
  if (first == Clock::time_point::max()) return -1;
  const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(first - Clock::now()).count() + 1;
  return static_cast<int>(std::clamp<long long>(left, 0, 60'000));
}

}  // namespace channel
}  // namespace tzc
