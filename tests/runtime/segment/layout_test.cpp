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

TEST(Layout, VersionOne) {
  EXPECT_EQ(layout_version, 1u);
  EXPECT_EQ(sizeof(SegmentHeader), 64u);
  EXPECT_EQ(offsetof(SegmentHeader, version), 8u);
  EXPECT_EQ(offsetof(SegmentHeader, slots), 12u);
  EXPECT_EQ(offsetof(SegmentHeader, id), 16u);
  EXPECT_EQ(offsetof(SegmentHeader, size), 24u);
  EXPECT_EQ(offsetof(SegmentHeader, name), 32u);
  EXPECT_EQ(sizeof(BlockHeader), 24u);
  EXPECT_EQ(offsetof(BlockHeader, generation), 4u);
  EXPECT_EQ(offsetof(BlockHeader, slot), 8u);
  EXPECT_EQ(offsetof(BlockHeader, size), 16u);
  EXPECT_EQ(block_header_bytes, 64u);
  EXPECT_EQ(sizeof(AckHeader), 24u);
  EXPECT_EQ(offsetof(AckHeader, releases), 16u);
  EXPECT_EQ(ack_file_bytes(3), 64u + 3 * 8u);
}

TEST(Layout, References) {
  EXPECT_EQ(sizeof(SegmentOffer), 32u);
  EXPECT_EQ(sizeof(BlockRef), 32u);
  EXPECT_EQ(offsetof(BlockRef, slot), 24u);
  EXPECT_EQ(offsetof(BlockRef, generation), 28u);
}

}  // namespace
}  // namespace segment
}  // namespace tzc
