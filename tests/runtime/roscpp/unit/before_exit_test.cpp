// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/before_exit.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <thread>

namespace tzc {
namespace detail {
namespace {

std::atomic<bool> is_destroyed{false};

/// What exit() does after the wait: its handlers run in the opposite order.
void destroy_slowly() {
  is_destroyed = true;
  std::this_thread::sleep_for(std::chrono::milliseconds(600));
}

void run_a_step_during_exit() {
  ::_exit(BeforeExit() ? 1 : 0);
}

/// A thread that is inside a step for some time, and ends the process with 1 where exit() destroys something meanwhile.
std::thread begin_long_step() {
  static std::atomic<bool> begun{false};
  std::thread thread([] {
    const BeforeExit step;
    begun = true;
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    if (is_destroyed) ::_exit(1);
  });
  while (!begun) std::this_thread::yield();
  return thread;
}

TEST(BeforeExitDeathTest, exit_waits_for_the_steps_of_other_threads) {
  testing::FLAGS_gtest_death_test_style = "threadsafe";
  const auto program = [] {
    std::atexit(destroy_slowly);
    begin_long_step().detach();
    std::exit(0);
  };
  EXPECT_EXIT(program(), testing::ExitedWithCode(0), "");
}

TEST(BeforeExitDeathTest, no_step_begins_later) {
  testing::FLAGS_gtest_death_test_style = "threadsafe";
  const auto program = [] {
    std::atexit(run_a_step_during_exit);
    {
      EXPECT_TRUE(BeforeExit());
    }
    std::exit(2);
  };
  EXPECT_EXIT(program(), testing::ExitedWithCode(0), "");
}

TEST(BeforeExitDeathTest, a_forked_child_waits_for_nobody) {
  testing::FLAGS_gtest_death_test_style = "threadsafe";
  const auto program = [] {
    std::atexit([] { ::_exit(BeforeExit() ? 0 : 1); });
    begin_long_step().detach();
    const pid_t child = ::fork();
    if (child == 0) std::exit(2);
    int status = 0;
    ::waitpid(child, &status, 0);
    ::_exit(WEXITSTATUS(status));
  };
  EXPECT_EXIT(program(), testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace detail
}  // namespace tzc
