// SPDX-License-Identifier: BSD-3-Clause
#include "channel/wire/record.h"

#include "channel/subscribe/received_message.h"
#include "support.h"

namespace tzc {
namespace channel {
namespace test {
namespace {

TEST(Record, seals_its_buffers) {
  const auto memory = memory_of(mb);
  const BufferPtr buffer = memory->allocate(10);
  EXPECT_TRUE(text_record("x", {buffer}));
  EXPECT_TRUE(buffer->sealed());
}

TEST(Record, keeps_its_buffers_alive) {
  const auto memory = memory_of(mb);
  RecordPtr record = text_record("x", {memory->allocate(mb)});
  EXPECT_FALSE(memory->allocate(mb));
  record.reset();
  EXPECT_TRUE(memory->allocate(mb));
}

TEST(Record, refuses_missing_and_too_many_buffers) {
  EXPECT_FALSE(text_record("x", {nullptr}));
  const auto memory = memory_of(mb);
  EXPECT_FALSE(text_record("x", std::vector<BufferPtr>(5000, memory->allocate(1))));
  EXPECT_TRUE(text_record("x", std::vector<BufferPtr>(4096, memory->allocate(1))));
}

TEST(Record, says_why_it_cannot_be_made) {
  EXPECT_TRUE(can_carry(std::size_t{1} << 30, 4096));
  const Status many = can_carry(0, 4097);
  ASSERT_FALSE(many);
  EXPECT_NE(many.error().text().find("4097 separate arrays"), std::string::npos) << many.error().text();
  const Status large = can_carry((std::size_t{1} << 30) + 1, 0);
  ASSERT_FALSE(large);
  EXPECT_NE(large.error().text().find("1 GiB"), std::string::npos) << large.error().text();
}

TEST(Record, one_that_cannot_be_made_is_counted) {
  const auto out = publisher();
  const auto in = idle_subscriber(out->address());
  EXPECT_EQ(out->publish(text_record("x", std::vector<BufferPtr>(4097, out->memory()->allocate(1)))), 0u);
  EXPECT_EQ(out->publish(text_record("y")), 1u);
  EXPECT_EQ(out->stats().published, 2u);
  EXPECT_EQ(out->stats().not_records, 1u);
}

std::string control_part_in(const RecordPtr& record) {
  const RecordParts parts = parts_of(*record);
  return std::string(reinterpret_cast<const char*>(parts.control), parts.control_size);
}

// The ring takes what is small, whatever the control part's length.
TEST(Record, has_its_control_part_in_a_block_when_that_fits_no_slot) {
  const auto memory = memory_of(4 * mb), arrays = memory_of(mb);
  for (const std::size_t size : {0, 100, 300, 500, 2000, 70'000, 1'000'000}) {
    const std::string control(size, 'c');
    const RecordPtr record = make_record(7, control.data(), size, {arrays->allocate(10)}, memory.get());
    ASSERT_TRUE(record);
    EXPECT_LE(record->size(), 468u) << size;
    EXPECT_EQ(record->buffers().size(), size < 468 - 24 - 32 ? 1u : 2u) << size;
    EXPECT_EQ(control_part_in(record), control);
  }
}

TEST(Record, has_its_control_part_in_itself_when_there_is_no_memory_for_it) {
  const auto memory = memory_of(mb);
  const BufferPtr everything = memory->allocate(mb);
  const std::string control(2000, 'c');
  const RecordPtr record = make_record(7, control.data(), control.size(), {}, memory.get());
  ASSERT_TRUE(record);
  EXPECT_TRUE(record->buffers().empty());
  EXPECT_EQ(control_part_in(record), control);
}

TEST(Record, parses_what_it_encodes) {
  const auto memory = memory_of(mb);
  const RecordPtr record = text_record("control", {memory->allocate(100), memory->allocate(200)});
  ParsedBody parsed;
  ASSERT_TRUE(parse_body(record->data(), record->size(), parsed));
  EXPECT_EQ(parsed.header.tag, 7u);
  EXPECT_EQ(parsed.header.block_count, 2u);
  EXPECT_EQ(std::string(reinterpret_cast<const char*>(parsed.control), parsed.header.control_size),
            "control");
}

TEST(Record, a_truncated_body_is_malformed) {
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
