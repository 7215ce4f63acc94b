// SPDX-License-Identifier: BSD-3-Clause
// Which memory files a subscriber knows: offered when they are needed, retired when their memory is gone.
#include "support.h"

namespace tzc {
namespace channel {
namespace test {
namespace {

TEST(Segments, too_many_live_segments_are_refused_not_fatal) {
  const auto out = publisher();
  Inbox in(out->address());
  std::vector<std::shared_ptr<SegmentMemory>> memories;
  std::size_t refused = 0;
  for (int i = 0; i < 260; ++i) {
    memories.push_back(memory_of(4096));
    refused += out->publish(text_record("x", {filled(*memories.back(), 100, 1)})) == 0 ? 1 : 0;
  }
  EXPECT_EQ(refused, 4u);
  EXPECT_TRUE(in.subscriber->stats().connected) << in.reason();
  EXPECT_EQ(out->publish(text_record("without memory")), 1u);
}

TEST(Segments, segments_of_a_dead_memory_are_let_go) {
  const auto out = publisher();
  Inbox in(out->address());
  for (int i = 0; i < 600; ++i) {  // more than a connection may have at a time
    const auto other = memory_of(mb);
    ASSERT_EQ(out->publish(text_record("x", {filled(*other, 1000, 1)})), 1u) << i;
    ASSERT_TRUE(in.wait_for(1));
    in.clear();
  }
  EXPECT_TRUE(in.subscriber->stats().connected) << in.reason();
}

// The memory is gone and the subscriber holds nothing of it, but the publisher still has a block of it; the
// other block's memory is new to the subscriber.
TEST(Segments, a_record_may_use_a_block_of_a_memory_that_is_gone) {
  const auto out = publisher();
  Inbox in(out->address());
  auto gone = memory_of(mb);
  const BufferPtr old_block = filled(*gone, 100, 1);
  out->publish(text_record("x", {old_block}));
  ASSERT_TRUE(in.wait_for(1));
  in.clear();
  gone.reset();
  ASSERT_EQ(out->publish(text_record("y", {old_block, filled(*out->memory(), 100, 2)})), 1u);
  ASSERT_TRUE(in.wait_for(1));
  const auto blocks = in.messages()[0]->blocks();
  ASSERT_EQ(blocks.size(), 2u);
  EXPECT_TRUE(all_bytes_are(blocks[0], 1));
  EXPECT_TRUE(all_bytes_are(blocks[1], 2));
}

}  // namespace
}  // namespace test
}  // namespace channel
}  // namespace tzc
