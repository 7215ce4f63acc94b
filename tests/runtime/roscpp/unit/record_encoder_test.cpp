// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/publish/record_encoder.h"

#include <gtest/gtest.h>
#include <tzc/process_memory.h>

#include <boost/make_shared.hpp>
#include <memory>
#include <new>

#include "roscpp/upgrade/offer.h"

namespace tzc {
namespace detail {
namespace {

/// Its arrays find no shared memory, and its bytes none on the heap.
struct Huge {};

bool encode_nothing(const void*, const std::shared_ptr<MemorySource>&, message::Encoded&) {
  return false;
}
ros::SerializedMessage serialize_nothing(const void*) {
  throw std::bad_alloc();
}

MessageCodec codec_of_huge() {
  MessageCodec codec = {};
  codec.type = &typeid(Huge);
  codec.encode = &encode_nothing;
  codec.serialize = &serialize_nothing;
  return codec;
}

ros::SerializedMessage huge() {
  ros::SerializedMessage message;
  message.message = boost::make_shared<Huge>();
  message.type_info = &typeid(Huge);
  return message;
}

TEST(RecordEncoder, a_message_without_any_memory_is_dropped_and_counted) {
  for (const OnExhausted on_exhausted : {OnExhausted::deliver, OnExhausted::drop}) {
    RecordEncoder encoder("/image", *SegmentMemory::create(MemoryOptions()), on_exhausted);
    encoder.codecs().add(codec_of_huge());
    for (std::uint32_t number = 0; number < 3; ++number) {
      const ros::SerializedMessage message = huge();
      for (int link = 0; link < 2; ++link)
        EXPECT_FALSE(encoder.of_pointer(message, 2, [number] { return number; }).record);
    }
    EXPECT_EQ(encoder.statistics().dropped, 3u);
    EXPECT_EQ(encoder.statistics().exhausted, 3u);
  }
}

ros::SerializedMessage serialize_too_much(const void*) {
  throw ros::Exception("Buffer Overrun");  // as roscpp's serializer beyond 4 GiB
}
boost::shared_ptr<void> view_something(const std::uint8_t*, std::size_t, const std::vector<ConstBlock>&,
                                       std::shared_ptr<const void>) {
  return boost::make_shared<Huge>();
}

TEST(RecordEncoder, what_roscpp_cannot_hold_goes_back_as_nothing) {
  MessageCodec codec = codec_of_huge();
  codec.view = &view_something;
  for (const auto serialize : {&serialize_nothing, &serialize_too_much}) {
    codec.serialize = serialize;
    RecordEncoder encoder("/image", *SegmentMemory::create(MemoryOptions()), OnExhausted::deliver);
    encoder.codecs().add(codec);
    const channel::RecordPtr record = channel::make_record(kControlPart, "c", 1, {});
    EXPECT_FALSE(encoder.to_stock_bytes(record).buf);
  }
}

/// No arrays, and many fields.
struct Wide {};

bool encode_much(const void*, const std::shared_ptr<MemorySource>&, message::Encoded& encoded) {
  encoded.control.assign(10'000, 'c');
  return true;
}

ros::SerializedMessage wide() {
  ros::SerializedMessage message;
  message.message = boost::make_shared<Wide>();
  message.type_info = &typeid(Wide);
  return message;
}

// A memory whose size the user chose holds as many arrays as before.
TEST(RecordEncoder, large_control_parts_take_nothing_of_the_memory_for_arrays) {
  MemoryOptions options;
  options.size = std::size_t{1} << 20;
  options.queue_size = 10;
  const auto arrays = *SegmentMemory::create(options);
  RecordEncoder encoder("/wide", arrays, OnExhausted::deliver);
  MessageCodec codec = codec_of_huge();
  codec.type = &typeid(Wide);
  codec.encode = &encode_much;
  encoder.codecs().add(codec);
  std::vector<channel::RecordPtr> kept;
  for (std::uint32_t number = 0; number < 500; ++number) {
    kept.push_back(encoder.of_pointer(wide(), 1, [number] { return number; }).record);
    const channel::RecordParts parts = channel::parts_of(*kept.back());
    ASSERT_EQ(std::string(reinterpret_cast<const char*>(parts.control), parts.control_size),
              std::string(10'000, 'c'));
  }
  EXPECT_EQ(arrays->stats().allocated, 0u);
}

constexpr std::size_t bytes_of_text = 100'000;
int looked = 0;

/// Large, but for what `arrays` of its bytes are.
template <std::size_t arrays>
bool encode_text(const std::uint8_t*, std::size_t size, const std::shared_ptr<MemorySource>& memory,
                 message::Encoded& encoded) {
  ++looked;
  encoded.control.assign(size - arrays, 'c');
  encoded.copied_bytes = arrays;
  if (arrays != 0) encoded.buffers.push_back(memory->allocate(arrays));
  return true;
}
bool encode_without_heap(const std::uint8_t*, std::size_t, const std::shared_ptr<MemorySource>&,
                         message::Encoded&) {
  throw std::bad_alloc();
}

ros::SerializedMessage text() {
  ros::SerializedMessage message;
  message.num_bytes = bytes_of_text + 4;
  message.buf.reset(new std::uint8_t[message.num_bytes]());
  message.message_start = message.buf.get() + 4;
  return message;
}

class SerializedText : public ::testing::Test {
 protected:
  SerializedText() { looked = 0; }
  void encode_by(bool (*encode)(const std::uint8_t*, std::size_t, const std::shared_ptr<MemorySource>&,
                                message::Encoded&)) {
    MessageCodec codec = codec_of_huge();
    codec.encode_serialized = encode;
    encoder_.codecs().add(codec);
  }
  RecordEncoder encoder_{"/text", *SegmentMemory::create(MemoryOptions()), OnExhausted::deliver};
};

TEST_F(SerializedText, with_few_arrays_goes_as_it_is_and_is_seldom_looked_at) {
  encode_by(&encode_text<1000>);
  for (int number = 0; number < 100; ++number) {
    const OutgoingMessage sent = encoder_.of_bytes(text(), 1);
    ASSERT_TRUE(sent.record);
    EXPECT_FALSE(sent.shared);
  }
  EXPECT_LE(looked, 8);
}

TEST_F(SerializedText, which_is_mostly_arrays_is_shared) {
  encode_by(&encode_text<90'000>);
  for (int number = 0; number < 100; ++number) EXPECT_TRUE(encoder_.of_bytes(text(), 1).shared);
  EXPECT_EQ(looked, 100);
}

TEST_F(SerializedText, goes_as_it_is_where_the_heap_has_no_room_to_read_it) {
  encode_by(&encode_without_heap);
  EXPECT_TRUE(encoder_.of_bytes(text(), 1).record);
  EXPECT_EQ(encoder_.statistics().dropped, 0u);
}

// A connect callback may publish to one subscriber while roscpp's thread publishes to all.
TEST_F(SerializedText, for_one_subscriber_alone_is_made_beside_that_for_all) {
  encode_by(&encode_text<90'000>);
  const ros::SerializedMessage all = text();
  EXPECT_TRUE(encoder_.of_bytes(all, 2).shared);
  EXPECT_TRUE(encoder_.of_bytes_alone(text()).shared);
  EXPECT_TRUE(encoder_.of_bytes(all, 2).shared);
  EXPECT_EQ(looked, 2);
}

}  // namespace
}  // namespace detail
}  // namespace tzc
