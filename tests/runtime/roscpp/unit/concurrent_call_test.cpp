// SPDX-License-Identifier: BSD-3-Clause
// Who unsubscribes waits for callbacks that run beside others, and none waits for another one that waits.
#include "roscpp/subscribe/concurrent_call.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <future>
#include <thread>
#include <utility>

namespace tzc {
namespace detail {
namespace {

constexpr std::uint64_t one = 1, other = 2;

/// A thread that is in a call until it is let out.
class Caller {
 public:
  explicit Caller(
      std::uint64_t id, std::function<void()> in_call = [] {})
      : thread_([this, id, in_call = std::move(in_call)] {
          const ConcurrentCall call(id);
          begun_.set_value();
          in_call();
          let_out_.get_future().wait();
        }) {
    begun_.get_future().wait();
  }
  ~Caller() { thread_.join(); }

  void let_out() { let_out_.set_value(); }

 private:
  std::promise<void> begun_, let_out_;
  std::thread thread_;
};

std::future<void> wait_for_end(std::uint64_t id) {
  return std::async(std::launch::async, [id] { ConcurrentCall::wait_for_end(id); });
}

bool is_over(const std::future<void>& wait) {
  return wait.wait_for(std::chrono::milliseconds(100)) == std::future_status::ready;
}

TEST(ConcurrentCall, is_waited_for_by_who_unsubscribes) {
  Caller first(one), second(one);
  const std::future<void> wait = wait_for_end(one);
  EXPECT_FALSE(is_over(wait));
  first.let_out();
  EXPECT_FALSE(is_over(wait));
  second.let_out();
  wait.wait();
}

TEST(ConcurrentCall, of_another_callback_is_not_waited_for) {
  Caller caller(other);
  ConcurrentCall::wait_for_end(one);
  caller.let_out();
}

TEST(ConcurrentCall, does_not_wait_for_itself_however_often_it_calls) {
  ConcurrentCall outer(one), inner, none;
  inner = ConcurrentCall(one);
  ConcurrentCall::wait_for_end(one);
  const std::future<void> wait = wait_for_end(one);
  none = ConcurrentCall();
  inner = ConcurrentCall();
  EXPECT_FALSE(is_over(wait)) << "the outer call runs still";
  outer = ConcurrentCall();
  wait.wait();
}

TEST(ConcurrentCall, that_unsubscribes_itself_waits_for_others_but_not_for_those_that_do_the_same) {
  std::atomic<int> ended{0};
  const auto unsubscribe = [&ended] {
    ConcurrentCall::wait_for_end(one);
    ++ended;
  };
  Caller runs(one);
  Caller first(one, unsubscribe), second(one, unsubscribe);
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
  EXPECT_EQ(ended, 0);
  runs.let_out();
  first.let_out();
  second.let_out();
}

struct LastUnsubscribe {
  ~LastUnsubscribe() { ConcurrentCall::wait_for_end(one); }
};

[[noreturn]] void exit_in_a_call() {
  alarm(60);  // who waits for himself waits for ever
  static const LastUnsubscribe last;
  const ConcurrentCall call(one);
  std::exit(3);
}

TEST(ConcurrentCallDeathTest, does_not_wait_for_itself_when_it_ends_the_program) {
  ::testing::GTEST_FLAG(death_test_style) = "threadsafe";
  EXPECT_EXIT(exit_in_a_call(), ::testing::ExitedWithCode(3), "");
}

}  // namespace
}  // namespace detail
}  // namespace tzc
