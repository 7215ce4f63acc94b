// SPDX-License-Identifier: BSD-3-Clause
#include "posix/thread.h"

#include <gtest/gtest.h>
#include <pthread.h>
#include <signal.h>

#include <future>
#include <string>

namespace tzc {
namespace posix {
namespace {

sigset_t mask_of_a_thread() {
  sigset_t mask;
  sigemptyset(&mask);
  auto thread = start_thread("tzc-test", [&mask] { pthread_sigmask(SIG_BLOCK, nullptr, &mask); });
  EXPECT_TRUE(thread);
  if (thread) thread->join();
  return mask;
}

TEST(Thread, leaves_signals_to_the_threads_of_the_program) {
  const sigset_t mask = mask_of_a_thread();
  for (const int number : {SIGINT, SIGTERM, SIGUSR1, SIGCHLD, SIGALRM})
    EXPECT_EQ(sigismember(&mask, number), 1);
}

TEST(Thread, has_its_faults_handled) {
  const sigset_t mask = mask_of_a_thread();
  for (const int number : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGTRAP})
    EXPECT_EQ(sigismember(&mask, number), 0);
}

std::size_t stack_of(pthread_t thread) {
  pthread_attr_t attributes;
  std::size_t size = 0;
  if (pthread_getattr_np(thread, &attributes) != 0) return 0;
  pthread_attr_getstacksize(&attributes, &size);
  pthread_attr_destroy(&attributes);
  return size;
}

struct Seen {
  std::size_t stack = 0;
  std::string name;
  sigset_t mask{};
};

Seen seen_by_a_small_thread() {
  std::promise<Seen> seen;
  const Status started = start_small_thread("tzc-small", [&seen] {
    Seen now;
    char name[16] = "";
    pthread_getname_np(pthread_self(), name, sizeof name);
    now.name = name;
    now.stack = stack_of(pthread_self());
    pthread_sigmask(SIG_BLOCK, nullptr, &now.mask);
    seen.set_value(now);
  });
  EXPECT_TRUE(started);
  return started ? seen.get_future().get() : Seen();
}

// Of 8 MB, the usual limit, a process whose data is limited to 100 MB has room for a few.
TEST(SmallThread, takes_little_of_a_limit_on_data) {
  const Seen seen = seen_by_a_small_thread();
  EXPECT_GE(seen.stack, std::size_t{1} << 19);
  EXPECT_LT(seen.stack, std::size_t{4} << 20) << "what thread-local variables take comes on top";
}

TEST(SmallThread, has_its_name_and_leaves_signals_to_the_threads_of_the_program) {
  const Seen seen = seen_by_a_small_thread();
  EXPECT_EQ(seen.name, "tzc-small");
  EXPECT_EQ(sigismember(&seen.mask, SIGINT), 1);
  EXPECT_EQ(sigismember(&seen.mask, SIGSEGV), 0);
}

}  // namespace
}  // namespace posix
}  // namespace tzc
