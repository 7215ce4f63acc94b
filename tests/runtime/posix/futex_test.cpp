// SPDX-License-Identifier: BSD-3-Clause
#include "posix/futex.h"

#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <new>
#include <thread>

namespace tzc {
namespace posix {
namespace {

TEST(Futex, does_not_sleep_on_another_value) {
  std::atomic<std::uint32_t> word{5};
  sleep_while(word, 4);
}

TEST(Futex, sleeps_for_the_time_given_at_most) {
  if (!has_shared_futex()) return;  // it is not used then
  std::atomic<std::uint32_t> word{5};
  for (int i = 0; i < 10; ++i) {  // the nanoseconds of its end, misread, would be too many now and then
    const auto begin = std::chrono::steady_clock::now();
    sleep_while(word, 5, std::chrono::milliseconds(100), 1);
    EXPECT_GE(std::chrono::steady_clock::now() - begin, std::chrono::milliseconds(90));
  }
}

TEST(Futex, wakes_the_one_who_is_meant) {
  if (!has_shared_futex()) return;  // it is not used then
  std::atomic<std::uint32_t> word{0};
  std::atomic<bool> returned{false};
  std::thread sleeper([&] {
    sleep_while(word, 0, std::chrono::seconds(30), 1);
    returned = true;
  });
  for (int i = 0; i < 20; ++i) {
    wake_sleeper(word, 2);
    ::usleep(1000);
  }
  EXPECT_FALSE(returned);
  while (!returned) {
    wake_sleeper(word, 1);
    ::usleep(1000);
  }
  sleeper.join();
}

TEST(Futex, wakes_another_process) {
  if (!has_shared_futex()) return;  // it is not used then
  void* memory = ::mmap(nullptr, 4096, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  ASSERT_NE(memory, MAP_FAILED);
  auto& word = *new (memory) std::atomic<std::uint32_t>{0};
  const pid_t child = ::fork();
  if (child == 0) {
    while (word == 0) sleep_while(word, 0);
    ::_exit(word == 1 ? 0 : 1);
  }
  ::usleep(1000);  // most likely it sleeps by now; it has to end in either case
  word = 1;
  wake_sleeper(word);
  int status = -1;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  EXPECT_EQ(status, 0);
  ::munmap(memory, 4096);
}

}  // namespace
}  // namespace posix
}  // namespace tzc
