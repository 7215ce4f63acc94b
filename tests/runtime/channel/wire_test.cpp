// SPDX-License-Identifier: BSD-3-Clause
#include "channel/wire/wire.h"

#include <gtest/gtest.h>

#include "channel/wire/shared_page.h"

// Publisher and subscriber may be built from different versions of this library. When a size here fails you
// changed the protocol: raise wire_version in channel/wire/wire.h, then update the numbers below.

namespace tzc {
namespace channel {
namespace {

using Word = std::atomic<std::uint64_t>;

TEST(Wire, version_seven) {
  EXPECT_EQ(wire_version, 7u);
  EXPECT_EQ(sizeof(Hello), 48u);
  EXPECT_EQ(sizeof(Welcome), 20u);
  EXPECT_EQ(sizeof(Refusal), 8u);
  EXPECT_EQ(sizeof(SegmentPacket), 56u);
  EXPECT_EQ(sizeof(RetireSegment), 16u);
  EXPECT_EQ(sizeof(RecordPrefix), 8u);
  EXPECT_EQ(sizeof(FragmentPrefix), 24u);
  EXPECT_EQ(sizeof(Unsubscribe), 4u);
  EXPECT_EQ(sizeof(TrunkWelcome), 16u);
  EXPECT_EQ(sizeof(WordPacket), 12u);
  EXPECT_EQ(sizeof(BodyHeader), 24u);
  EXPECT_EQ(offsetof(BodyHeader, made_at), 12u);
  EXPECT_EQ(sizeof(ConnectionPage), 4032u);
  EXPECT_EQ(sizeof(DoorbellPage), 576u);
  EXPECT_EQ(doorbell_numbers, 4096u);
}

TEST(DeliveryCursors, exactly_one_side_wins_a_record) {
  std::uint32_t taken = 0;
  Word word{pack(DeliveryCursors{5, 5})};
  EXPECT_TRUE(try_take(word, 6));
  EXPECT_FALSE(try_revoke(word, 6, taken));
  EXPECT_EQ(taken, 6u);
  EXPECT_TRUE(try_revoke(word, 7, taken));
  EXPECT_FALSE(try_take(word, 7));
  EXPECT_TRUE(try_take(word, 8));
}

TEST(DeliveryCursors, revoking_several_tells_which_are_still_the_publishers) {
  std::uint32_t taken = 0;
  Word word{pack(DeliveryCursors{5, 5})};
  try_take(word, 6);
  EXPECT_TRUE(try_revoke(word, 9, taken));
  EXPECT_EQ(taken, 6u);
  for (std::uint32_t sequence = 7; sequence <= 9; ++sequence) EXPECT_FALSE(try_take(word, sequence));
}

TEST(DeliveryCursors, sequence_numbers_wrap_around) {
  std::uint32_t taken = 0;
  Word word{pack(DeliveryCursors{0xfffffffe, 0xfffffffe})};
  for (const std::uint32_t sequence : {0xffffffffu, 0u, 1u}) EXPECT_TRUE(try_take(word, sequence));
  EXPECT_TRUE(try_revoke(word, 3, taken));
  EXPECT_FALSE(try_take(word, 2));
  EXPECT_TRUE(try_take(word, 4));
}

}  // namespace
}  // namespace channel
}  // namespace tzc
