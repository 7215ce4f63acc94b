// SPDX-License-Identifier: BSD-3-Clause
#include "segment/ack_word.h"

#include <gtest/gtest.h>

#include <thread>

namespace tzc {
namespace segment {
namespace {

using Word = std::atomic<std::uint64_t>;

AckCounts counts(const Word& word) {
  return unpack(word.load());
}

TEST(AckWord, mark_take_release) {
  Word word{0};
  EXPECT_TRUE(mark_in_flight(word, 7));
  EXPECT_FALSE(is_idle(word, 7));
  EXPECT_TRUE(take(word, 7));
  EXPECT_FALSE(is_idle(word, 7));
  EXPECT_TRUE(release(word, 7));
  EXPECT_TRUE(is_idle(word, 7));
}

TEST(AckWord, a_block_sent_twice_counts_twice) {
  Word word{0};
  mark_in_flight(word, 7);
  mark_in_flight(word, 7);
  take(word, 7);
  take(word, 7);
  release(word, 7);
  EXPECT_FALSE(is_idle(word, 7));
  release(word, 7);
  EXPECT_TRUE(is_idle(word, 7));
}

TEST(AckWord, only_what_is_taken_is_taken_again) {
  Word word{0};
  mark_in_flight(word, 7);
  EXPECT_FALSE(take_again(word));
  take(word, 7);
  EXPECT_TRUE(take_again(word));
  release(word, 7);
  EXPECT_FALSE(is_idle(word, 7));
  release(word, 7);
  EXPECT_TRUE(is_idle(word, 7));
  Word full{pack({7, 1, max_ack_count})};
  EXPECT_FALSE(take_again(full));
  EXPECT_EQ(full.load(), pack({7, 1, max_ack_count}));
}

TEST(AckWord, other_generations_are_never_touched) {
  Word word{0};
  mark_in_flight(word, 7);
  EXPECT_FALSE(take(word, 8));
  EXPECT_FALSE(revoke_in_flight(word, 6));
  EXPECT_FALSE(release(word, 8));
  EXPECT_TRUE(is_idle(word, 8));
  EXPECT_EQ(counts(word).in_flight, 1u);
}

TEST(AckWord, a_new_generation_forgets_the_old_counts) {
  Word word{pack({7, 3, 2})};
  mark_in_flight(word, 8);
  EXPECT_EQ(counts(word).generation, 8u);
  EXPECT_EQ(counts(word).in_flight, 1u);
  EXPECT_EQ(counts(word).taken, 0u);
}

TEST(AckWord, counters_never_wrap_into_each_other) {
  Word full{pack({7, max_ack_count, max_ack_count})};
  EXPECT_FALSE(mark_in_flight(full, 7));
  EXPECT_FALSE(take(full, 7));
  EXPECT_EQ(full.load(), pack({7, max_ack_count, max_ack_count}));
  Word empty{pack({7, 0, 0})};
  EXPECT_FALSE(take(empty, 7));
  EXPECT_FALSE(release(empty, 7));
  EXPECT_FALSE(revoke_in_flight(empty, 7));
  EXPECT_EQ(empty.load(), pack({7, 0, 0}));
}

TEST(AckWord, generations_wrap_around_past_zero) {
  EXPECT_EQ(next_generation(1), 2u);
  EXPECT_EQ(next_generation(0xffffffff), 1u);
  Word word{pack({0xffffffff, 1, 0})};
  EXPECT_TRUE(is_idle(word, 1));
  EXPECT_TRUE(mark_in_flight(word, 1));
  EXPECT_FALSE(take(word, 0xffffffff));
}

TEST(AckWord, a_peer_that_keeps_changing_the_word_does_not_keep_us_here) {
  Word word{pack({7, 1, 0})};
  std::atomic<bool> stop{false};
  std::thread hostile([&] {
    while (!stop) word.fetch_xor(std::uint64_t{1} << 15);
  });
  for (int i = 0; i < 1000; ++i) {
    mark_in_flight(word, 7);
    revoke_in_flight(word, 7);
  }
  stop = true;
  hostile.join();
}

}  // namespace
}  // namespace segment
}  // namespace tzc
