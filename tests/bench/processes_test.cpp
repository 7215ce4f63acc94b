// SPDX-License-Identifier: BSD-3-Clause
#include "processes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <functional>
#include <stdexcept>
#include <system_error>
#include <vector>

#include "poor_process.h"

namespace {

using namespace tzc::bench;
using testing::HasSubstr;
using tzc::test::has_children;
using tzc::test::in_poor_process;
using tzc::test::not_possible;
using tzc::test::ProcessEnd;

constexpr int expected = 0, unexpected = 1;

void wait_for_ever() {
  for (;;) ::pause();
}

/// Whether it threw, with the reason on standard error, and left nothing behind.
int fails_cleanly(const std::function<void()>& start) {
  try {
    start();
  } catch (const std::system_error& error) {
    std::fputs(error.what(), stderr);
    return has_children() ? unexpected : expected;
  }
  return unexpected;
}

/// In a process of its own, since what a signal does is a matter of the whole process. Its exit code.
int in_fresh_process(const std::function<int()>& body) {
  const pid_t child = ::fork();
  if (child == 0) ::_exit(body());
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

/// What comes of the signal when it is ignored, or is not, before hold_interrupts.
int interrupted_by(int signal, bool ignored) {
  return in_fresh_process([&] {
    ::signal(signal, ignored ? SIG_IGN : SIG_DFL);
    hold_interrupts();
    ::raise(signal);
    return interrupted() ? 1 : 0;
  });
}

TEST(InChild, says_why_no_process_can_be_started) {
  const ProcessEnd end = in_poor_process(0, [] { return fails_cleanly([] { in_child(wait_for_ever); }); });
  if (end.exited_with(not_possible)) GTEST_SKIP() << tzc::test::why_not_possible;
  EXPECT_TRUE(end.exited_with(expected)) << end.status;
  EXPECT_THAT(end.said, HasSubstr("cannot start a process: "));
}

TEST(InChild, ends_a_child_whose_body_throws) {
  const int code = in_fresh_process([] {
    try {
      ::close(STDERR_FILENO);  // where terminate speaks
      const pid_t child = in_child([] {
        const rlimit no_file{};
        ::setrlimit(RLIMIT_CORE, &no_file);
        throw std::runtime_error("in the child");
      });
      return wait_for(child) == Ending::failed ? 3 : 4;
    } catch (const std::runtime_error&) {
      return 5;  // a second parent
    }
  });
  EXPECT_EQ(code, 3);
}

TEST(InChildren, leave_none_behind_where_one_cannot_be_started) {
  const ProcessEnd end = in_poor_process(
      2, [] { return fails_cleanly([] { in_children(5, [](std::size_t) { wait_for_ever(); }); }); });
  if (end.exited_with(not_possible)) GTEST_SKIP() << tzc::test::why_not_possible;
  EXPECT_TRUE(end.exited_with(expected)) << end.status;
}

TEST(InChildren, are_numbered) {
  const std::vector<pid_t> children =
      in_children(3, [](std::size_t number) { ::_exit(number == 2 ? 0 : 1); });
  ASSERT_EQ(children.size(), 3u);
  EXPECT_EQ(wait_for(children[0]), Ending::failed);
  EXPECT_EQ(wait_for(children[1]), Ending::failed);
  EXPECT_EQ(wait_for(children[2]), Ending::exited);
}

// With -1 the kernel takes all processes of the user: as one who has no others.
TEST(Stop, leaves_out_what_is_no_process) {
  if (::geteuid() != 0) GTEST_SKIP() << "a failure would end all that this user runs";
  const ProcessEnd end = in_poor_process(2, [] {
    const pid_t bystander = in_child(wait_for_ever);
    stop({-1, 0});
    const bool runs = all_run({bystander});
    stop({bystander});
    return runs && !has_children() ? expected : unexpected;
  });
  if (end.exited_with(not_possible)) GTEST_SKIP() << tzc::test::why_not_possible;
  EXPECT_TRUE(end.exited_with(expected)) << end.status;
}

TEST(WaitFor, takes_no_other_child) {
  const pid_t other = in_child([] {});
  EXPECT_EQ(wait_for(-1), Ending::failed);
  EXPECT_EQ(wait_for(0), Ending::failed);
  EXPECT_EQ(wait_for(other), Ending::exited);
  EXPECT_EQ(wait_for(other), Ending::failed) << "it is gone";
}

// As after a starter that ignores SIGCHLD: the kernel then keeps no trace of a child that ends.
TEST(WaitFor, knows_how_a_child_ended_whatever_the_starter_ignored) {
  const int code = in_fresh_process([] {
    ::signal(SIGCHLD, SIG_IGN);
    const pid_t child = in_child([] {});
    return wait_for(child) == Ending::exited ? 3 : 4;
  });
  EXPECT_EQ(code, 3);
}

TEST(AllRun, is_not_said_of_what_is_no_process) {
  EXPECT_FALSE(all_run({-1}));
  EXPECT_TRUE(all_run({}));
}

TEST(HeldInterrupts, are_all_that_a_terminal_or_its_end_sends) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT})
    EXPECT_EQ(interrupted_by(signal, false), 1) << signal;
}

TEST(HeldInterrupts, leave_ignored_what_nohup_ignores) {
  for (const int signal : {SIGHUP, SIGQUIT}) EXPECT_EQ(interrupted_by(signal, true), 0) << signal;
}

TEST(HeldInterrupts, do_not_reach_children) {
  const int code = in_fresh_process([] {
    hold_interrupts();
    const pid_t child = in_child([] {
      for (const int signal : {SIGINT, SIGHUP, SIGQUIT}) ::raise(signal);
    });
    return wait_for(child) == Ending::exited ? 3 : 4;
  });
  EXPECT_EQ(code, 3);
}

TEST(TakeInterruptsAgain, does_so_for_those_that_the_parent_did_not_ignore) {
  const int code = in_fresh_process([] {
    ::signal(SIGHUP, SIG_IGN);
    ::signal(SIGINT, SIG_DFL);
    hold_interrupts();
    const pid_t child = in_child([] {
      take_interrupts_again();
      ::raise(SIGHUP);
      ::raise(SIGINT);
      ::_exit(0);
    });
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFSIGNALED(status) && WTERMSIG(status) == SIGINT ? 3 : 4;
  });
  EXPECT_EQ(code, 3);
}

TEST(WaitForNews, ends_with_a_child) {
  const int code = in_fresh_process([] {
    hold_interrupts();
    const pid_t child = in_child([] {});
    const auto start = std::chrono::steady_clock::now();
    while (all_run({child})) wait_for_news(std::chrono::minutes(1));
    return std::chrono::steady_clock::now() - start < std::chrono::seconds(30) ? 3 : 4;
  });
  EXPECT_EQ(code, 3);
}

}  // namespace
