// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/publish/memory_of_no_topic.h"

#include <gtest/gtest.h>
#include <tzc/detail/attachment.h>
#include <tzc/memory.h>

namespace tzc {
namespace detail {
namespace {

// In one test: what it tells of lasts as long as the process.
TEST(MemoryOfNoTopic, is_there_once_a_topic_has_some) {
  EXPECT_FALSE(memory_of_no_topic()) << "a node whose topics all stay on TCPROS needs none";
  EXPECT_FALSE(stats_of_no_topic());
  note_topic_with_memory();
  const std::shared_ptr<MemorySource> memory = memory_of_no_topic();
  ASSERT_TRUE(memory);
  const BufferPtr buffer = memory->allocate(100000);
  ASSERT_TRUE(buffer);
  EXPECT_EQ(stats_of_no_topic()->used_blocks, 1U);
  EXPECT_EQ(memory, memory_of_no_topic());
}

}  // namespace
}  // namespace detail
}  // namespace tzc
