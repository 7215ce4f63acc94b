// SPDX-License-Identifier: BSD-3-Clause
#include "latency.h"

#include <gtest/gtest.h>

#include "words.h"

namespace tzc::monitor {
namespace {

TEST(Latency, quantiles_are_the_ends_of_their_buckets) {
  Latencies latencies{};
  EXPECT_EQ(quantile_s(latencies, 0.5), 0);
  latencies[0] = 1;
  latencies[4] = 98;
  latencies[20] = 1;
  EXPECT_EQ(count(latencies), 100U);
  EXPECT_DOUBLE_EQ(quantile_s(latencies, 0.01), 1.024e-6);
  EXPECT_DOUBLE_EQ(quantile_s(latencies, 0.5), 16 * 1.024e-6);
  EXPECT_DOUBLE_EQ(quantile_s(latencies, 0.99), 16 * 1.024e-6);
  EXPECT_DOUBLE_EQ(quantile_s(latencies, 1), (1 << 20) * 1.024e-6);
}

// Half an hour in a stopped process is not "< 8.6 s".
TEST(Latency, the_last_bucket_has_no_end) {
  Latencies latencies{};
  latencies[22] = 99;
  EXPECT_EQ(latency_words(latencies), "< 4.3 s (99%: < 4.3 s)");
  latencies[23] = 5;
  EXPECT_EQ(latency_words(latencies), "< 4.3 s (99%: > 4.3 s)");
  latencies[23] = 901;
  EXPECT_EQ(latency_words(latencies), "> 4.3 s (99%: > 4.3 s)");
}

TEST(Latency, of_no_message_is_none) {
  EXPECT_EQ(latency_words(Latencies{}), "-");
}

TEST(Words, times_are_short) {
  EXPECT_EQ(short_time(1.024e-6), "1 us");
  EXPECT_EQ(short_time(262e-6), "262 us");
  EXPECT_EQ(short_time(2.097e-3), "2.1 ms");
  EXPECT_EQ(short_time(33.5e-3), "34 ms");
  EXPECT_EQ(short_time(1.07), "1.1 s");
  EXPECT_EQ(short_time(12), "12 s");
}

}  // namespace
}  // namespace tzc::monitor
