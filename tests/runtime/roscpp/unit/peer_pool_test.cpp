// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/upgrade/peer_pool.h"

#include <gtest/gtest.h>

#include <atomic>
#include <future>
#include <thread>
#include <vector>

namespace tzc {
namespace detail {
namespace {

using std::chrono::milliseconds;
using Clock = std::chrono::steady_clock;

PeerPool::Limits quick() {
  PeerPool::Limits limits;
  limits.slow = milliseconds(50);
  limits.first_pause = milliseconds(400);
  return limits;
}

TEST(PeerPool, runs_the_jobs_of_a_peer_in_order_and_one_at_a_time) {
  PeerPool pool;
  std::atomic<int> running{0}, most{0};
  std::vector<int> order;
  std::promise<void> done;
  for (int i = 0; i < 20; ++i)
    pool.post("peer", [&, i] {
      most = std::max(most.load(), ++running);
      order.push_back(i);
      std::this_thread::sleep_for(milliseconds(1));
      --running;
      if (i == 19) done.set_value();
    });
  done.get_future().wait();
  EXPECT_EQ(most, 1);
  for (int i = 0; i < 20; ++i) EXPECT_EQ(order[static_cast<std::size_t>(i)], i);
}

TEST(PeerPool, a_peer_that_does_not_answer_delays_no_other) {
  std::promise<void> answered;
  PeerPool pool(quick());
  std::promise<void> gate;
  const std::shared_future<void> open = gate.get_future().share();
  for (int i = 0; i < 10; ++i) pool.post("stopped", [open] { open.wait(); });
  pool.post("healthy", [&] { answered.set_value(); });
  EXPECT_EQ(answered.get_future().wait_for(std::chrono::seconds(60)), std::future_status::ready);
  gate.set_value();
}

TEST(PeerPool, many_peers_known_to_be_slow_leave_threads_for_others) {
  PeerPool pool(quick());
  std::promise<void> gate;
  const std::shared_future<void> open = gate.get_future().share();
  std::atomic<int> slow_again{0};
  for (int peer = 0; peer < 8; ++peer) {
    const std::string name = "slow" + std::to_string(peer);
    pool.post(name, [] { std::this_thread::sleep_for(milliseconds(60)); });
    pool.post(name, [&, open] {
      ++slow_again;
      open.wait();
    });
  }
  const Clock::time_point end = Clock::now() + std::chrono::seconds(60);
  while (slow_again < 2 && Clock::now() < end) std::this_thread::sleep_for(milliseconds(5));
  std::this_thread::sleep_for(milliseconds(600));  // all of the pauses are over
  EXPECT_EQ(slow_again, 2) << "half of the threads";
  std::promise<void> answered;
  pool.post("healthy", [&] { answered.set_value(); });
  EXPECT_EQ(answered.get_future().wait_for(std::chrono::seconds(60)), std::future_status::ready);
  gate.set_value();
}

TEST(PeerPool, a_slow_peer_has_a_pause) {
  PeerPool pool(quick());
  std::promise<Clock::time_point> first, second;
  pool.post("slow", [&] {
    std::this_thread::sleep_for(milliseconds(60));
    first.set_value(Clock::now());
  });
  pool.post("slow", [&] { second.set_value(Clock::now()); });
  const Clock::time_point end_of_first = first.get_future().get();
  EXPECT_GE(second.get_future().get() - end_of_first, milliseconds(390));
}

TEST(PeerPool, waits_for_the_due_time) {
  PeerPool pool;
  const Clock::time_point start = Clock::now();
  std::promise<Clock::time_point> ran;
  pool.post("peer", [&] { ran.set_value(Clock::now()); }, milliseconds(100));
  EXPECT_GE(ran.get_future().get() - start, milliseconds(100));
}

TEST(PeerPool, a_job_may_post_the_next_one) {
  PeerPool pool;
  std::promise<void> third;
  const auto last = [&] { third.set_value(); };
  const auto second = [&] {
    pool.post("peer", last, milliseconds(6000));
  };  // longer than a thread stays idle
  pool.post("peer", [&] { pool.post("peer", second, milliseconds(100)); });
  EXPECT_EQ(third.get_future().wait_for(std::chrono::seconds(60)), std::future_status::ready);
}

TEST(PeerPool, a_job_that_comes_when_the_last_thread_ends_is_run) {
  PeerPool::Limits limits;
  limits.idle = std::chrono::microseconds(200);
  PeerPool pool(limits);
  for (int i = 0; i < 5000; ++i) {
    std::promise<void> done;
    pool.post("peer", [&] { done.set_value(); });
    ASSERT_EQ(done.get_future().wait_for(std::chrono::seconds(10)), std::future_status::ready) << i;
    std::this_thread::sleep_for(std::chrono::microseconds(100 + i % 200));
  }
}

TEST(PeerPool, an_exception_ends_the_job_alone) {
  PeerPool pool;
  std::promise<void> next;
  pool.post("peer", [] { throw std::bad_alloc(); });
  pool.post("peer", [&] { next.set_value(); });
  EXPECT_EQ(next.get_future().wait_for(std::chrono::seconds(60)), std::future_status::ready);
}

TEST(PeerPool, its_end_waits_for_the_running_job_and_drops_the_others) {
  std::atomic<bool> begun{false}, ended{false}, other{false};
  {
    PeerPool pool;
    pool.post("peer", [&] {
      begun = true;
      std::this_thread::sleep_for(milliseconds(50));
      ended = true;
    });
    pool.post("peer", [&] { other = true; });
    while (!begun) std::this_thread::yield();
  }
  EXPECT_TRUE(ended);
  EXPECT_FALSE(other);
}

}  // namespace
}  // namespace detail
}  // namespace tzc
