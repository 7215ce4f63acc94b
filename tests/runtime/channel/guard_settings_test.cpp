// SPDX-License-Identifier: BSD-3-Clause
// Settings of guard mode, each in a process of its own, and the program of all tests of guard mode.
#include <signal.h>

#include <cstdlib>
#include <cstring>

#include "guard_support.h"

namespace tzc {
namespace channel {
namespace test {
namespace {

constexpr char write_late_option[] = "--write-late";

/// What this program does with write_late_option.
int publish_and_write_late() {
  const Exchange exchange;
  const BufferPtr sent = exchange.publish(5000, 1);
  write_late(sent->data(), 3);
  return 0;
}

/// A process of this program that writes late, with a setting of its own.
Outcome write_late_with(const char* setting) {
  return run([=] {
    ::setenv("TZC_GUARD", setting, 1);
    ::execl("/proc/self/exe", "guard_test", write_late_option, nullptr);
    return 1;
  });
}

TEST(GuardSettings, abort_ends_the_process_in_a_child) {
  const Outcome outcome = write_late_with("abort");
  EXPECT_TRUE(WIFSIGNALED(outcome.status) && WTERMSIG(outcome.status) == SIGABRT) << outcome.status;
  EXPECT_EQ(outcome.reports(), 1u) << outcome.errors;
}

TEST(GuardSettings, the_end_says_what_was_watched_in_a_child) {
  const Outcome outcome = write_late_with("1");
  EXPECT_TRUE(outcome.says("1 blocks of published messages were watched, 1 late accesses from 1 places"))
      << outcome.errors;
}

TEST(GuardSettings, off_and_misspelt_ones_in_a_child) {
  for (const char* setting : {"0", "off"}) {
    const Outcome outcome = write_late_with(setting);
    EXPECT_TRUE(ended_with(outcome, 0) && outcome.errors.empty()) << outcome.errors;
  }
  EXPECT_TRUE(write_late_with("yess").says("TZC_GUARD cannot be 'yess'"));
}

}  // namespace
}  // namespace test
}  // namespace channel
}  // namespace tzc

int main(int argc, char** argv) {
  if (std::getenv("TZC_GUARD") == nullptr) {
    ::setenv("TZC_GUARD", "1", 1);
    ::execv("/proc/self/exe", argv);
  }
  ::testing::InitGoogleTest(&argc, argv);
  if (argc == 2 && std::strcmp(argv[1], tzc::channel::test::write_late_option) == 0)
    return tzc::channel::test::publish_and_write_late();
  return RUN_ALL_TESTS();
}
