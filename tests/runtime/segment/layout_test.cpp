// SPDX-License-Identifier: BSD-3-Clause
#include "segment/layout.h"

#include <gtest/gtest.h>

#include <cstddef>

#include "segment/received_segment.h"

// Two processes map these structures, possibly built from different versions of this library. When a line
// here fails you changed the shared layout: raise layout_version in segment/layout.h, then update the numbers
// below.

namespace tzc {
namespace segment {
namespace {

TEST(Layout, version_two) {
  EXPECT_EQ(layout_version, 2u);
  EXPECT_EQ(sizeof(SegmentHeader), 64u);
  EXPECT_EQ(offsetof(SegmentHeader, version), 8u);
  EXPECT_EQ(offsetof(SegmentHeader, slots), 12u);
  EXPECT_EQ(offsetof(SegmentHeader, id), 16u);
  EXPECT_EQ(offsetof(SegmentHeader, size), 24u);
  EXPECT_EQ(offsetof(SegmentHeader, name), 32u);
  EXPECT_EQ(sizeof(BlockHeader), 32u);
  EXPECT_EQ(offsetof(BlockHeader, generation), 4u);
  EXPECT_EQ(offsetof(BlockHeader, slot), 8u);
  EXPECT_EQ(offsetof(BlockHeader, offset), 16u);
  EXPECT_EQ(offsetof(BlockHeader, size), 24u);
  EXPECT_EQ(block_header_bytes, 64u);
  EXPECT_EQ(block_header_offset(2), 64u + 2 * 64u);
  EXPECT_EQ(payloads_offset(63, 4096), 4096u);
  EXPECT_EQ(payloads_offset(64, 4096), 8192u);
  EXPECT_EQ(sizeof(AckHeader), 24u);
  EXPECT_EQ(offsetof(AckHeader, released), 16u);
  EXPECT_EQ(ack_words_offset(3), 64u + 64u);
  EXPECT_EQ(ack_words_offset(65536), 64u + 65536u / 8);
  EXPECT_EQ(ack_file_bytes(3), 64u + 64u + 3 * 8u);
}

TEST(Layout, references) {
  EXPECT_EQ(sizeof(SegmentOffer), 48u);
  EXPECT_EQ(sizeof(BlockRef), 32u);
  EXPECT_EQ(offsetof(BlockRef, slot), 24u);
  EXPECT_EQ(offsetof(BlockRef, generation), 28u);
}

}  // namespace
}  // namespace segment
}  // namespace tzc
