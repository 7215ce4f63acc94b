// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/publish/record_encoder.h"

#include <gtest/gtest.h>
#include <tzc/process_memory.h>

#include <boost/make_shared.hpp>
#include <memory>
#include <new>

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

}  // namespace
}  // namespace detail
}  // namespace tzc
