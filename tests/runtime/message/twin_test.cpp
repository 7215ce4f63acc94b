// SPDX-License-Identifier: BSD-3-Clause
// tzc:: messages: their wire format, their partial form, allocate, and what happens to them after publishing.
#include <tzc/message.h>
#include <tzc/sensor_msgs/Image.h>
#include <tzc/sensor_msgs/PointCloud.h>

#include "random_message.h"
#include "test_memory.h"

namespace tzc {
namespace message {
namespace {

namespace stock = ::sensor_msgs;
using sensor_msgs::Image;
using sensor_msgs::PointCloud;

template <class M>
std::vector<std::uint8_t> wire(const M& message) {
  std::vector<std::uint8_t> bytes(ros::serialization::serializationLength(message));
  ros::serialization::OStream stream(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
  ros::serialization::serialize(stream, message);
  return bytes;
}

template <class M>
M from_wire(std::vector<std::uint8_t> bytes) {
  M message;
  ros::serialization::IStream stream(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
  ros::serialization::deserialize(stream, message);
  return message;
}

template <class M>
std::vector<const void*> array_addresses(const M& message) {
  std::vector<const void*> addresses;
  test::visit_arrays(message, [&](const void* data, std::size_t) { addresses.push_back(data); });
  return addresses;
}

class Twin : public ::testing::Test {
 protected:
  Image image(std::size_t bytes) {
    Image message;
    message.encoding = "mono8";
    message.data.resize(bytes);
    for (std::size_t i = 0; i < bytes; ++i) message.data[i] = static_cast<std::uint8_t>(i);
    return message;
  }
  stock::PointCloud stock_cloud(unsigned seed = 3) { return test::random_message<stock::PointCloud>(seed); }
  Encoded encoded(const Image& message) {
    Encoded result;
    EXPECT_TRUE(encode(message, memory_, result));
    return result;
  }

  std::shared_ptr<test::TestMemory> memory_ = std::make_shared<test::TestMemory>();
};

TEST_F(Twin, speaks_the_stock_wire_format) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const auto cloud = stock_cloud(seed);
    const PointCloud twin(cloud);
    EXPECT_EQ(wire(cloud), wire(twin));
    EXPECT_TRUE(twin == from_wire<PointCloud>(wire(cloud)));
    EXPECT_EQ(cloud, to_stock(twin));
  }
}

TEST_F(Twin, refuses_a_wire_length_that_the_stream_does_not_have) {
  auto bytes = wire(image(4));
  bytes[bytes.size() - 8 + 3] = 0x7f;  // the array's count
  EXPECT_THROW(from_wire<Image>(bytes), ros::serialization::StreamOverrunException);
}

TEST_F(Twin, has_the_partial_form_of_its_stock_type) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const auto cloud = stock_cloud(seed);
    Encoded of_stock, of_twin;
    ASSERT_TRUE(encode(cloud, memory_, of_stock));
    ASSERT_TRUE(encode(PointCloud(cloud), memory_, of_twin));
    EXPECT_EQ(of_stock.control, of_twin.control);
    EXPECT_EQ(cloud, *stock_view(PointCloud(cloud), of_twin));
  }
}

TEST_F(Twin, allocate_puts_all_arrays_into_one_buffer) {
  const auto cloud = stock_cloud();
  PointCloud twin(cloud);
  ASSERT_TRUE(allocate(twin, memory_));
  EXPECT_EQ(1, memory_->allocations);
  EXPECT_EQ(cloud, to_stock(twin)) << "contents are kept";

  Encoded encoded;
  ASSERT_TRUE(encode(twin, memory_, encoded));
  EXPECT_EQ(0u, encoded.copied_bytes);
  EXPECT_EQ(1u, encoded.buffers.size());
  EXPECT_EQ(array_addresses(twin), array_addresses(*stock_view(twin, encoded)));
}

TEST_F(Twin, allocate_before_the_sizes_are_known) {
  Image message;
  ASSERT_TRUE(allocate(message, memory_));
  EXPECT_EQ(0, memory_->allocations);
  message.data.resize(1000);
  EXPECT_TRUE(in_segment(message.data.data()));
  EXPECT_EQ(0u, encoded(message).copied_bytes);
}

TEST_F(Twin, allocate_again_moves_nothing) {
  Image message = image(1000);
  ASSERT_TRUE(allocate(message, memory_));
  const auto before = array_addresses(message);
  ASSERT_TRUE(allocate(message, memory_));
  EXPECT_EQ(before, array_addresses(message));
  EXPECT_EQ(1, memory_->allocations);
}

TEST_F(Twin, allocate_honours_a_reserved_capacity) {
  Image message;
  message.data.reserve(1000);
  ASSERT_TRUE(allocate(message, memory_));
  for (int i = 0; i < 1000; ++i) message.data.push_back(1);
  EXPECT_EQ(1, memory_->allocations);
  EXPECT_TRUE(in_segment(message.data.data()));
}

TEST_F(Twin, without_memory_the_message_stays_as_it_is) {
  Image message = image(1000);
  memory_->exhausted = true;
  EXPECT_FALSE(allocate(message, memory_));
  EXPECT_EQ(image(1000).data, message.data);
  memory_->exhausted = false;
  EXPECT_EQ(1000u, encoded(message).copied_bytes) << "publishing tries again";
}

TEST_F(Twin, allocate_after_publish_takes_room_but_copies_only_when_written) {
  Image message = image(1000);
  ASSERT_TRUE(allocate(message, memory_));
  const Encoded published = encoded(message);
  ASSERT_TRUE(allocate(message, memory_));
  EXPECT_EQ(2, memory_->allocations);
  const Image& read = message;
  EXPECT_EQ(published.buffers[0], read.data.buffer()) << "still the published bytes";
  memory_->exhausted = true;
  message.data[0] = 99;
  EXPECT_TRUE(in_segment(read.data.data())) << "the room was taken before";
  EXPECT_EQ(0, published.buffers[0]->data()[0]);
  EXPECT_EQ(1, read.data[1]);
}

TEST_F(Twin, what_allocate_has_reserved_is_there_however_often_it_is_called) {
  Image message = image(1000);
  ASSERT_TRUE(allocate(message, memory_));
  encoded(message);
  ASSERT_TRUE(allocate(message, memory_));
  memory_->exhausted = true;
  EXPECT_TRUE(allocate(message, memory_)) << "the program left a frame out";
  message.data[0] = 1;
  EXPECT_TRUE(in_segment(message.data.data()));
}

TEST_F(Twin, what_allocate_has_reserved_is_no_other_memorys) {
  Image message = image(1000);
  ASSERT_TRUE(allocate(message, memory_));
  encoded(message);
  ASSERT_TRUE(allocate(message, memory_));
  const auto other = std::make_shared<test::TestMemory>();
  ASSERT_TRUE(allocate(message, other));
  EXPECT_EQ(other->allocations, 1);
}

TEST_F(Twin, allocate_takes_room_for_what_is_rebuilt_by_push_back) {
  Image message;
  ASSERT_TRUE(allocate(message, memory_));
  const auto build = [&] {
    message.data.clear();
    for (int i = 0; i < 900; ++i) message.data.push_back(static_cast<std::uint8_t>(i));
    return encoded(message);
  };
  const Encoded first = build();
  ASSERT_TRUE(allocate(message, memory_));
  const int allocations = memory_->allocations;
  const Encoded second = build();
  EXPECT_EQ(allocations, memory_->allocations) << "allocate took the room";
  EXPECT_EQ(0u, second.copied_bytes);
  EXPECT_NE(first.buffers, second.buffers);
}

TEST_F(Twin, without_a_memory_nothing_is_allocated) {
  Image message = image(10);
  EXPECT_FALSE(allocate(message, std::shared_ptr<MemorySource>()));
  EXPECT_EQ(image(10), message);
}

TEST_F(Twin, no_write_after_publish_reaches_a_subscriber) {
  Image message = image(1000);
  ASSERT_TRUE(allocate(message, memory_));
  Encoded published = encoded(message);
  const auto view = stock_view(message, published);
  const stock::Image before(*view);
  message.data[5] = 77;
  message.data.resize(2000);
  std::fill(message.data.begin(), message.data.end(), 1);
  message = image(3);
  EXPECT_EQ(before, *view);
}

/// A message that lasts, and that nobody allocated.
TEST_F(Twin, published_from_the_heap_is_copied_once) {
  Image message = image(1000);
  const Encoded first = encoded(message);
  EXPECT_EQ(1000u, first.copied_bytes);
  const Encoded second = encoded(message);
  EXPECT_EQ(0u, second.copied_bytes);
  EXPECT_EQ(first.buffers, second.buffers);
  for (int i = 0; i < 3; ++i) {
    message.data.assign(2000, static_cast<std::uint8_t>(i));
    Encoded later = encoded(message);
    EXPECT_EQ(0u, later.copied_bytes);
    EXPECT_EQ(to_stock(message), *stock_view(message, later));
  }
}

TEST_F(Twin, published_from_the_heap_without_memory_stays_there) {
  Image message = image(1000);
  memory_->exhausted = true;
  Encoded none;
  EXPECT_FALSE(encode(message, memory_, none));
  message.data[0] = 5;
  memory_->exhausted = false;
  Encoded later = encoded(message);
  EXPECT_EQ(1000u, later.copied_bytes);
  EXPECT_EQ(5, stock_view(message, later)->data[0]);
}

TEST_F(Twin, published_twice_and_to_two_memories_is_copied_never) {
  Image message = image(1000);
  ASSERT_TRUE(allocate(message, memory_));
  const Encoded first = encoded(message), second = encoded(message);
  EXPECT_EQ(first.buffers, second.buffers);
  const auto other = std::make_shared<test::TestMemory>();
  Encoded third;
  ASSERT_TRUE(encode(message, other, third));
  EXPECT_EQ(0u, third.copied_bytes);
  EXPECT_EQ(0, other->allocations);
}

TEST_F(Twin, an_array_shared_too_often_in_one_message_is_refused) {
  PointCloud cloud;
  cloud.channels.resize(1);
  cloud.channels[0].values.resize(1000);
  ASSERT_TRUE(allocate(cloud, memory_));
  Encoded encoded;
  ASSERT_TRUE(encode(cloud, memory_, encoded));
  const auto shared = cloud.channels[0];
  cloud.channels.assign(10, shared);
  ASSERT_TRUE(encode(cloud, memory_, encoded));
  EXPECT_EQ(1u, encoded.buffers.size());
  EXPECT_TRUE(stock_view(cloud, encoded));
  cloud.channels.assign(1000, shared);
  EXPECT_FALSE(encode(cloud, memory_, encoded)) << "receivers would not believe it";
}

TEST_F(Twin, control_part_is_laid_out_as_documented) {
  Image message = image(300);
  message.header.seq = 0x01020304;
  message.header.frame_id = "f";
  const Encoded result = encoded(message);
  // When this fails the layout has changed: give the channel's handshake a new version.
  const auto at = [&](std::size_t offset, auto value) {
    std::memcpy(&value, result.control.data() + offset, sizeof value);
    return static_cast<std::uint64_t>(value);
  };
  EXPECT_EQ(0x01020304u, at(0, std::uint32_t()));
  const std::size_t entry = result.control.size() - 20;
  EXPECT_EQ(300u, at(entry, std::uint32_t())) << "count";
  EXPECT_EQ(1u, at(entry + 4, std::uint32_t())) << "element size";
  EXPECT_EQ(0u, at(entry + 8, std::uint32_t())) << "block";
  EXPECT_EQ(0u, at(entry + 12, std::uint64_t())) << "offset";
  EXPECT_EQ(17u + 4 + 4 + 9 + 1 + 4 + 20, result.control.size());
}

}  // namespace
}  // namespace message
}  // namespace tzc
