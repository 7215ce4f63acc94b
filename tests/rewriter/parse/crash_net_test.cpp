// SPDX-License-Identifier: BSD-3-Clause
// A crash on one unit ends the work on that unit and nothing else.
#include "parse/crash_net.h"

#include <gtest/gtest.h>

#include <atomic>
#include <csignal>
#include <cstdlib>
#include <stdexcept>
#include <thread>
#include <vector>

namespace tzc::rewriter {
namespace {

volatile int* volatile nowhere = nullptr;

volatile bool ends = false;

/// Takes stack with each call, which no compiler may turn into a loop.
int depth_of(volatile int depth) {
  volatile char frame[1 << 10];
  frame[0] = static_cast<char>(depth);
  return ends ? depth : depth_of(depth + 1) + frame[0];
}

TEST(CrashNet, work_that_ends_does_so_on_another_thread) {
  std::thread::id worker;
  EXPECT_EQ(signal_that_ends([&] { worker = std::this_thread::get_id(); }), 0);
  EXPECT_NE(worker, std::thread::id());
  EXPECT_NE(worker, std::this_thread::get_id());
}

TEST(CrashNet, signals) {
  EXPECT_EQ(signal_that_ends([] { *nowhere = 1; }), SIGSEGV);
  EXPECT_EQ(signal_that_ends([] { std::abort(); }), SIGABRT);
  EXPECT_EQ(signal_that_ends([] { std::raise(SIGILL); }), SIGILL);
  EXPECT_EQ(signal_that_ends([] {}), 0);
}

TEST(CrashNet, an_exhausted_stack) {
  EXPECT_EQ(signal_that_ends([] { depth_of(0); }), SIGSEGV);
  EXPECT_EQ(signal_that_ends([] { depth_of(0); }), SIGSEGV);
}

TEST(CrashNet, exceptions_reach_the_caller) {
  EXPECT_THROW(signal_that_ends([] { throw std::runtime_error("no such file"); }), std::runtime_error);
  EXPECT_EQ(signal_that_ends([] {}), 0);
}

TEST(CrashNet, a_crash_on_one_thread_leaves_the_others_alone) {
  std::atomic<int> ended{0}, crashed{0};
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i)
    threads.emplace_back([&, i] {
      for (int round = 0; round < 25; ++round) {
        const bool crashes = (i + round) % 2 == 0;
        const int signal = signal_that_ends([&] { crashes ? std::abort() : static_cast<void>(++ended); });
        crashed += signal == SIGABRT;
      }
    });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(ended, 50);
  EXPECT_EQ(crashed, 50);
}

}  // namespace
}  // namespace tzc::rewriter
