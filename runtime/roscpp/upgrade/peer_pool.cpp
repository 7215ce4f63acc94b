// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/upgrade/peer_pool.h"

#include <algorithm>
#include <iterator>

#include "roscpp/transport_thread.h"

namespace tzc {
namespace detail {
namespace {

/// Peers that stay known for being slow; beyond this number those without jobs are dropped.
constexpr std::size_t kMostPeers = 256;

}  // namespace

PeerPool::~PeerPool() {
  std::unique_lock<std::mutex> lock(mutex_);
  stopping_ = true;
  wake_.notify_all();
  wake_.wait(lock, [this] { return threads_ == 0; });
}

void PeerPool::post(const std::string& peer, Job job, std::chrono::microseconds delay) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (stopping_) return;
  if (peers_.size() > kMostPeers) forget_idle();
  peers_[peer].jobs.emplace(Clock::now() + delay, std::move(job));
  if (idle_ == 0 && threads_ < limits_.threads) start_thread();
  wake_.notify_all();
}

void PeerPool::forget_idle() {
  for (Peers::iterator one = peers_.begin(); one != peers_.end();) {
    const bool is_idle = !one->second.busy && one->second.jobs.empty();
    one = is_idle ? peers_.erase(one) : std::next(one);
  }
}

void PeerPool::start_thread() {
  if (start_small_transport_thread("tzc-peers", [this] { run(); })) ++threads_;
}

PeerPool::Clock::time_point PeerPool::due(const Peer& peer) const {
  return std::max(peer.jobs.begin()->first, peer.not_before);
}

PeerPool::Peers::iterator PeerPool::earliest() {
  const bool slow_may_run = serving_slow_ < std::max<std::size_t>(1, limits_.threads / 2);
  Peers::iterator found = peers_.end();
  for (Peers::iterator one = peers_.begin(); one != peers_.end(); ++one) {
    const Peer& peer = one->second;
    if (peer.busy || peer.jobs.empty() || (peer.slow_jobs > 0 && !slow_may_run)) continue;
    if (found == peers_.end() || due(peer) < due(found->second)) found = one;
  }
  return found;
}

void PeerPool::run() {
  std::unique_lock<std::mutex> lock(mutex_);
  while (!stopping_) {
    const Clock::time_point now = Clock::now();
    const Peers::iterator next = earliest();
    if (next != peers_.end() && due(next->second) <= now) {
      run_next(lock, next);
      continue;
    }
    const Clock::time_point end = now + limits_.idle;
    ++idle_;
    wake_.wait_until(lock, next == peers_.end() ? end : std::min(end, due(next->second)));
    --idle_;
    // One idle thread stays for the jobs that are not due yet, and for those that came when its time was over.
    if (Clock::now() >= end && (idle_ > 0 || earliest() == peers_.end())) break;
  }
  --threads_;
  wake_.notify_all();
}

void PeerPool::run_next(std::unique_lock<std::mutex>& lock, Peers::iterator peer) {
  Job job = std::move(peer->second.jobs.begin()->second);
  peer->second.jobs.erase(peer->second.jobs.begin());
  peer->second.busy = true;
  const bool is_slow = peer->second.slow_jobs > 0;
  serving_slow_ += is_slow ? 1 : 0;
  if (idle_ == 0 && threads_ < limits_.threads) start_thread();
  lock.unlock();
  const Clock::time_point start = Clock::now();
  run_job(std::move(job));
  lock.lock();
  serving_slow_ -= is_slow ? 1 : 0;
  finish(peer, Clock::now() - start);
  wake_.notify_all();
}

void PeerPool::finish(Peers::iterator one, Clock::duration took) {
  Peer& peer = one->second;
  peer.busy = false;
  if (took > limits_.slow) {
    const auto pause = limits_.first_pause * (1 << std::min(peer.slow_jobs++, 10));
    peer.not_before = Clock::now() + std::min<Clock::duration>(pause, limits_.longest_pause);
  } else {
    peer.slow_jobs = 0;
  }
  if (peer.jobs.empty() && peer.slow_jobs == 0) peers_.erase(one);
}

}  // namespace detail
}  // namespace tzc
