// SPDX-License-Identifier: BSD-3-Clause
#include "channel/record.h"

#include "channel/received_message.h"
#include "support.h"

namespace tzc {
namespace channel {
namespace test {
namespace {

TEST(Record, SealsItsBuffers) {
  const auto memory = memory_of(mb);
  const BufferPtr buffer = memory->allocate(10);
  EXPECT_TRUE(text_record("x", {buffer}));
  EXPECT_TRUE(buffer->sealed());
}

TEST(Record, KeepsItsBuffersAlive) {
  const auto memory = memory_of(mb);
  RecordPtr record = text_record("x", {memory->allocate(mb)});
  EXPECT_FALSE(memory->allocate(mb));
  record.reset();
  EXPECT_TRUE(memory->allocate(mb));
}

TEST(Record, RefusesMissingAndTooManyBuffers) {
  EXPECT_FALSE(text_record("x", {nullptr}));
  const auto memory = memory_of(mb);
  EXPECT_FALSE(text_record("x", std::vector<BufferPtr>(5000, memory->allocate(1))));
  EXPECT_TRUE(text_record("x", std::vector<BufferPtr>(4096, memory->allocate(1))));
}

TEST(Record, ParsesWhatItEncodes) {
  const auto memory = memory_of(mb);
  const RecordPtr record = text_record("control", {memory->allocate(100), memory->allocate(200)});
  ParsedBody parsed;
  ASSERT_TRUE(parse_body(record->data(), record->size(), parsed));
  EXPECT_EQ(parsed.header.tag, 7u);
  EXPECT_EQ(parsed.header.block_count, 2u);
  EXPECT_EQ(std::string(reinterpret_cast<const char*>(parsed.control), parsed.header.control_size),
            "control");
}

TEST(Record, ATruncatedBodyIsMalformed) {
  const auto memory = memory_of(mb);
  const RecordPtr record = text_record("control", {memory->allocate(100)});
  ParsedBody parsed;
  for (std::size_t size = 0; size < record->size(); ++size)
    EXPECT_FALSE(parse_body(record->data(), size, parsed)) << size;
}

}  // namespace
}  // namespace test
}  // namespace channel
}  // namespace tzc
