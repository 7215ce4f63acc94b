// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <random>

#include "messages.h"
#include "pairing/alignment.h"
#include "pairing/pairing.h"

namespace tzc::compare {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using testing::picture;
using testing::stamped;
using testing::stream;
using testing::unstamped;

using Data = std::vector<std::uint8_t>;

Pairing paired(const std::vector<Bytes>& first, const std::vector<Bytes>& second) {
  return pair_messages(stream("/a", first).messages, stream("/a", second).messages);
}

std::size_t lcs_length(const std::vector<std::uint64_t>& a, const std::vector<std::uint64_t>& b) {
  std::vector<std::vector<std::size_t>> best(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 1; i <= a.size(); ++i)
    for (std::size_t j = 1; j <= b.size(); ++j)
      best[i][j] = a[i - 1] == b[j - 1] ? best[i - 1][j - 1] + 1 : std::max(best[i - 1][j], best[i][j - 1]);
  return best[a.size()][b.size()];
}

TEST(align, is_a_longest_common_subsequence) {
  std::mt19937 dice(1);
  for (int round = 0; round < 3000; ++round) {
    std::vector<std::uint64_t> a(dice() % 12), b(dice() % 12);
    for (auto& value : a) value = dice() % 4;
    for (auto& value : b) value = dice() % 4;
    const std::vector<IndexPair> pairs = align(a, b);
    ASSERT_EQ(pairs.size(), lcs_length(a, b)) << round;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      ASSERT_EQ(a.at(pairs[i].first), b.at(pairs[i].second));
      ASSERT_TRUE(i == 0 || (pairs[i - 1].first < pairs[i].first && pairs[i - 1].second < pairs[i].second));
    }
  }
}

TEST(align, stays_quick_when_nothing_is_equal) {
  std::vector<std::uint64_t> a(50'000), b(50'000);
  for (std::size_t i = 0; i < a.size(); ++i) a[i] = 2 * i, b[i] = 2 * i + 1;
  a.front() = b.front();
  a.back() = b.back();
  EXPECT_EQ(align(a, b).size(), 2U) << "beyond the bound the equal ends are still found";
}

TEST(pairing, by_stamp_tells_loss_from_content) {
  const Pairing pairing = paired(stamped({1, 2, 3, 4, 5}), stamped({1, 2, 4, 5}));
  EXPECT_EQ(pairing.by, PairedBy::stamp);
  EXPECT_THAT(pairing.first_only.between, ElementsAre(2));
  EXPECT_EQ(pairing.first_only.size(), 1U);
  EXPECT_EQ(pairing.second_only.size(), 0U);
  EXPECT_EQ(pairing.pairs.size(), 4U);
}

TEST(pairing, messages_outside_the_common_time_stand_apart) {
  const Pairing pairing = paired(stamped({1, 2, 3, 4}), stamped({3, 4, 5}));
  EXPECT_THAT(pairing.first_only.before, ElementsAre(0, 1));
  EXPECT_THAT(pairing.second_only.after, ElementsAre(2));
  EXPECT_THAT(pairing.first_only.between, IsEmpty());
}

TEST(pairing, reordered) {
  const Pairing by_stamp = paired(stamped({1, 2, 3, 4, 5}), stamped({1, 4, 2, 3, 5}));
  EXPECT_EQ(by_stamp.reordered, 1U);
  EXPECT_EQ(by_stamp.first_only.size(), 0U);
  const Pairing by_content = paired(unstamped({1, 2, 3, 4, 5}, 1), unstamped({1, 4, 2, 3, 5}, 2));
  EXPECT_EQ(by_content.by, PairedBy::content);
  EXPECT_EQ(by_content.reordered, 1U);
  EXPECT_EQ(by_content.pairs.size(), 5U);
}

TEST(pairing, duplicates) {
  const Pairing pairing = paired(stamped({1, 2, 3}), stamped({1, 2, 2, 3}));
  EXPECT_EQ(pairing.second_only.between.size(), 1U);
  EXPECT_EQ(pairing.duplicates, 1U);
  const Pairing other = paired(stamped({1, 2, 4}), stamped({1, 2, 3, 4}));
  EXPECT_EQ(other.second_only.between.size(), 1U);
  EXPECT_EQ(other.duplicates, 0U) << "a message of its own";
}

TEST(pairing, one_stamp_several_messages) {
  const std::vector<Bytes> first{picture(0, 7, {1}), picture(0, 7, {2}), picture(0, 7, {3})};
  const std::vector<Bytes> second{picture(0, 7, {3}), picture(0, 7, {9}), picture(0, 7, {1})};
  const Pairing pairing = paired(first, second);
  EXPECT_THAT(pairing.pairs, ElementsAre(IndexPair{0, 2}, IndexPair{1, 1}, IndexPair{2, 0}));
}

TEST(pairing, other_stamps_each_run_pairs_by_content) {
  const Pairing pairing = paired(unstamped({3, 4, 5, 6, 7}, 1), unstamped({5, 7, 8}, 2));
  EXPECT_EQ(pairing.by, PairedBy::content);
  EXPECT_THAT(pairing.pairs, ElementsAre(IndexPair{2, 0}, IndexPair{4, 1}));
  EXPECT_THAT(pairing.first_only.before, ElementsAre(0, 1));
  EXPECT_THAT(pairing.first_only.between, ElementsAre(3));
  EXPECT_THAT(pairing.second_only.after, ElementsAre(2));
}

TEST(pairing, nothing_equal_pairs_by_sequence_number) {
  std::vector<Bytes> first, second;
  for (std::uint32_t i = 0; i < 6; ++i)
    first.push_back(picture(10 + i, 100 + i, {1, static_cast<std::uint8_t>(i)}));
  for (std::uint32_t i = 2; i < 6; ++i)
    second.push_back(picture(10 + i, 900 + i, {2, static_cast<std::uint8_t>(i)}));
  const Pairing pairing = paired(first, second);
  EXPECT_EQ(pairing.by, PairedBy::sequence);
  EXPECT_THAT(pairing.pairs, ElementsAre(IndexPair{2, 0}, IndexPair{3, 1}, IndexPair{4, 2}, IndexPair{5, 3}));
}

TEST(pairing, without_a_header_by_order) {
  const std::string text = "uint8 value\n";
  const auto values = [&](const Data& data) {
    std::vector<Bytes> messages;
    for (const std::uint8_t value : data) messages.push_back({value});
    return stream("/a", messages, "test/Value", text).messages;
  };
  EXPECT_EQ(pair_messages(values({1, 2}), values({3, 4})).by, PairedBy::order);
  const Pairing changed = pair_messages(values({1, 2, 3, 4}), values({1, 9, 3, 4}));
  EXPECT_THAT(changed.pairs, ElementsAre(IndexPair{0, 0}, IndexPair{1, 1}, IndexPair{2, 2}, IndexPair{3, 3}));
  EXPECT_EQ(pair_messages(values(Data(100, 5)), values(Data(97, 5))).first_only.size(), 3U);
}

TEST(pairing, stamps_that_were_never_set_pair_by_content) {
  EXPECT_EQ(paired({picture(1, 0, {1}), picture(2, 0, {2})}, {picture(1, 0, {1}), picture(2, 0, {2})}).by,
            PairedBy::content);
}

}  // namespace
}  // namespace tzc::compare
