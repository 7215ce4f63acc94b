// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/upgrade/retry_policy.h"

#include <gtest/gtest.h>

namespace tzc {
namespace detail {
namespace {

using std::chrono::milliseconds;

TEST(RetryPolicy, pauses_double_up_to_half_a_minute) {
  EXPECT_EQ(pause_after(1), milliseconds(250));
  EXPECT_EQ(pause_after(2), milliseconds(500));
  EXPECT_EQ(pause_after(7), milliseconds(16000));
  for (int attempts = 8; attempts <= 10; ++attempts) EXPECT_EQ(pause_after(attempts), milliseconds(32000));
}

TEST(RetryPolicy, what_leads_nowhere_is_asked_seldom) {
  for (int attempts = 11; attempts < 1000; ++attempts)
    EXPECT_EQ(pause_after(attempts), std::chrono::minutes(5));
}

TEST(RetryPolicy, ten_attempts_last_a_minute_and_a_half) {
  milliseconds sum(0);
  for (int attempts = 1; attempts < 10; ++attempts) sum += pause_after(attempts);
  EXPECT_GT(sum, std::chrono::seconds(90));
  EXPECT_LT(sum, std::chrono::seconds(100));
}

TEST(RetryPolicy, no_attempt_yet_is_as_after_the_first) {
  EXPECT_EQ(pause_after(0), pause_after(1));
  EXPECT_EQ(pause_after(-5), pause_after(1));
}

}  // namespace
}  // namespace detail
}  // namespace tzc
