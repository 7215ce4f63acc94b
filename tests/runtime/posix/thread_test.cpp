// SPDX-License-Identifier: BSD-3-Clause
#include "posix/thread.h"

#include <gtest/gtest.h>
#include <pthread.h>
#include <signal.h>

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

}  // namespace
}  // namespace posix
}  // namespace tzc
