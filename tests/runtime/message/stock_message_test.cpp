// SPDX-License-Identifier: BSD-3-Clause
// Properties of partial serialization that hold for every message type, on random messages.
#include <algorithm>
#include <memory>

#include "message_types.h"
#include "random_message.h"
#include "test_memory.h"

namespace tzc {
namespace message {
namespace {

template <class M>
class StockMessage : public ::testing::Test {
 protected:
  static constexpr unsigned seeds = 20;

  std::shared_ptr<test::TestMemory> memory_ = std::make_shared<test::TestMemory>();
};
TYPED_TEST_SUITE(StockMessage, test::MessageTypes);

TYPED_TEST(StockMessage, view_and_copy_equal_the_original) {
  for (unsigned seed = 0; seed < this->seeds; ++seed) {
    const auto original = test::random_message<TypeParam>(seed);
    Encoded encoded;
    ASSERT_TRUE(encode(original, this->memory_, encoded));
    const auto blocks = test::blocks_of(encoded);
    const auto view = make_view<TypeParam>(encoded.control.data(), encoded.control.size(), blocks, nullptr);
    const auto copy = make_copy<TypeParam>(encoded.control.data(), encoded.control.size(), blocks);
    ASSERT_TRUE(view && copy);
    EXPECT_EQ(original, *view);
    EXPECT_EQ(original, *copy);
    EXPECT_EQ(original, *callback_view(original, encoded));
  }
}

TYPED_TEST(StockMessage, what_roscpp_serialized_is_encoded_like_the_message) {
  for (unsigned seed = 0; seed < this->seeds; ++seed) {
    const auto original = test::random_message<TypeParam>(seed);
    const ros::SerializedMessage wire = ros::serialization::serializeMessage(original);
    Encoded encoded, by_bytes;
    ASSERT_TRUE(encode(original, this->memory_, encoded));
    ASSERT_TRUE(
        encode_serialized<TypeParam>(wire.message_start, wire.num_bytes - 4, this->memory_, by_bytes));
    EXPECT_EQ(encoded.control, by_bytes.control);
    EXPECT_EQ(encoded.copied_bytes, by_bytes.copied_bytes);
    EXPECT_EQ(original, *stock_view(original, by_bytes));
  }
}

TYPED_TEST(StockMessage, bytes_that_roscpp_would_not_write_do_no_harm) {
  const auto original = test::random_message<TypeParam>(5, 9);
  const ros::SerializedMessage wire = ros::serialization::serializeMessage(original);
  const std::size_t size = wire.num_bytes - 4;
  const auto encodes = [&](std::size_t length, std::size_t place, std::uint8_t difference) {
    const std::unique_ptr<std::uint8_t[]> exact(
        new std::uint8_t[length]);  // a sanitizer sees what reads beyond
    std::copy(wire.message_start, wire.message_start + length, exact.get());
    if (place < length) exact[place] ^= difference;
    Encoded encoded;
    return encode_serialized<TypeParam>(exact.get(), length, this->memory_, encoded);
  };
  EXPECT_TRUE(encodes(size, size, 0));
  for (std::size_t length = 0; length < size; ++length) EXPECT_FALSE(encodes(length, length, 0)) << length;
  for (std::size_t place = 0; place < size; ++place)
    for (const int difference : {1, 0x80, 0xff}) encodes(size, place, static_cast<std::uint8_t>(difference));
}

TYPED_TEST(StockMessage, arrays_are_copied_once_into_one_buffer) {
  for (unsigned seed = 0; seed < this->seeds; ++seed) {
    const auto original = test::random_message<TypeParam>(seed);
    Encoded encoded;
    ASSERT_TRUE(encode(original, this->memory_, encoded));
    const std::size_t size = test::data_size(original);
    EXPECT_EQ(size, encoded.copied_bytes);
    EXPECT_EQ(size == 0 ? 0u : 1u, encoded.buffers.size());
  }
}

TYPED_TEST(StockMessage, views_borrow_and_copies_do_not) {
  const auto original = test::random_message<TypeParam>(1);
  Encoded encoded;
  ASSERT_TRUE(encode(original, this->memory_, encoded));
  const auto copy =
      make_copy<TypeParam>(encoded.control.data(), encoded.control.size(), test::blocks_of(encoded));
  const auto view = stock_view(original, encoded);
  test::visit_arrays(*view, [](const void* data, std::size_t) { EXPECT_TRUE(in_segment(data)); });
  test::visit_arrays(*copy, [](const void* data, std::size_t) { EXPECT_FALSE(in_segment(data)); });
  test::visit_arrays(TypeParam(*view), [](const void* data, std::size_t) { EXPECT_FALSE(in_segment(data)); });
}

TYPED_TEST(StockMessage, publishing_a_view_copies_nothing) {
  const auto original = test::random_message<TypeParam>(2);
  Encoded encoded, again;
  ASSERT_TRUE(encode(original, this->memory_, encoded));
  const auto view = stock_view(original, encoded);
  ASSERT_TRUE(encode(*view, this->memory_, again));
  EXPECT_EQ(0u, again.copied_bytes);
  EXPECT_EQ(encoded.buffers, again.buffers);
  EXPECT_EQ(encoded.control, again.control);
}

TYPED_TEST(StockMessage, exhausted_memory_is_reported) {
  const auto original = test::random_message<TypeParam>(3);
  this->memory_->exhausted = true;
  Encoded encoded;
  EXPECT_EQ(test::data_size(original) == 0, encode(original, this->memory_, encoded));
}

TYPED_TEST(StockMessage, control_part_is_the_wire_without_arrays) {
  const auto original = test::random_message<TypeParam>(4);
  std::size_t arrays = 0;
  test::visit_arrays(original, [&](const void*, std::size_t) { ++arrays; });
  Encoded encoded;
  ASSERT_TRUE(encode(original, this->memory_, encoded));
  EXPECT_LE(encoded.control.size(), ros::serialization::serializationLength(original) + arrays * 16);
}

}  // namespace
}  // namespace message
}  // namespace tzc
