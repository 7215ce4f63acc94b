// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// What must hold for every generated type, with random contents.
#include <gtest/gtest.h>
#include <tzc/message.h>

#include <algorithm>
#include <cstring>
#include <memory>
#include <random>
#include <sstream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "random_message.h"
#include "test_memory.h"

namespace tzc {
namespace test {

using Bytes = std::vector<std::uint8_t>;

template <class M>
Bytes wire_bytes(const M& message) {
  Bytes bytes(ros::serialization::serializationLength(message));
  ros::serialization::OStream stream(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
  ros::serialization::serialize(stream, message);
  EXPECT_EQ(stream.getLength(), 0u) << "serializationLength() and serialize() disagree";
  return bytes;
}

template <class M>
M from_wire(Bytes& bytes) {
  M message;
  ros::serialization::IStream stream(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
  ros::serialization::deserialize(stream, message);
  EXPECT_EQ(stream.getLength(), 0u) << "bytes are left over";
  return message;
}

template <class Stock>
std::string printed(const Stock& message) {
  std::ostringstream text;
  text << message;
  return text.str();
}

/// Two stock messages are the same: by their bytes, which cover every field; roscpp's == does not compile for
/// all.
template <class Stock>
void expect_same(const Stock& actual, const Bytes& expected_bytes) {
  EXPECT_EQ(wire_bytes(actual), expected_bytes);
}

template <class Twin, class Stock>
void check_traits() {
  namespace traits = ros::message_traits;
  EXPECT_STREQ(traits::MD5Sum<Twin>::value(), traits::MD5Sum<Stock>::value());
  EXPECT_STREQ(traits::DataType<Twin>::value(), traits::DataType<Stock>::value());
  EXPECT_STREQ(traits::Definition<Twin>::value(), traits::Definition<Stock>::value());
  static_assert(traits::IsMessage<Twin>::value && traits::IsMessage<const Twin>::value, "a ROS message");
  static_assert(traits::IsFixedSize<Twin>::value == traits::IsFixedSize<Stock>::value, "same fixed size");
  static_assert(traits::HasHeader<Twin>::value == traits::HasHeader<Stock>::value, "same header");
  static_assert(traits::HasHeader<const Twin>::value == traits::HasHeader<const Stock>::value, "same header");
}

/// stock -> twin -> wire is roscpp's own serialization; wire -> twin -> stock is what it was; so is the
/// printed text. Assigned to a twin, a stock message replaces all that this one had.
template <class Twin, class Stock>
void check_wire(const Stock& stock, Bytes bytes) {
  const Twin twin(stock);
  EXPECT_EQ(wire_bytes(twin), bytes);
  const Twin read = from_wire<Twin>(bytes);
  expect_same(static_cast<Stock>(read), bytes);
  EXPECT_EQ(printed(read), printed(stock));
  Twin assigned(stock);
  assigned = Stock();
  EXPECT_EQ(wire_bytes(assigned), wire_bytes(Stock()));
  assigned = stock;
  EXPECT_EQ(wire_bytes(assigned), bytes);
}

template <class Twin, class Stock, class = void>
struct Compares : std::false_type {};
template <class Twin, class Stock>
struct Compares<Twin, Stock, decltype(void(std::declval<const Twin&>() == std::declval<const Stock&>()))>
    : std::true_type {};

/// Twins and stock messages are compared with each other as roscpp compares stock messages. A twin has no such operator
/// where roscpp's does not compile.
template <class Twin, class Stock>
void check_comparison(const Stock& one, const Stock& other, std::true_type /* has one */) {
  const bool same = one == other;
  const Twin twin(one);
  EXPECT_EQ(twin == other, same);
  EXPECT_EQ(other == twin, same);
  EXPECT_EQ(twin != other, !same);
  EXPECT_EQ(other != twin, !same);
  EXPECT_EQ(twin == Twin(other), same);
}

template <class Twin, class Stock>
void check_comparison(const Stock&, const Stock&, std::false_type /* has one */) {}

/// Blocks in memory of exactly their size, so that a sanitizer sees the first byte read beyond.
struct Received {
  std::vector<std::unique_ptr<std::uint8_t[]>> memory;
  std::vector<ConstBlock> blocks;

  explicit Received(const message::Encoded& encoded) {
    for (const ConstBlock& block : blocks_of(encoded)) {
      memory.emplace_back(new std::uint8_t[block.size]);
      std::memcpy(memory.back().get(), block.data, block.size);
      blocks.push_back({memory.back().get(), block.size});
    }
  }
  bool contains(const void* address, std::size_t bytes) const {
    const auto* const first = static_cast<const std::uint8_t*>(address);
    return std::any_of(blocks.begin(), blocks.end(), [=](const ConstBlock& b) {
      return first >= b.data && bytes <= b.size && first <= b.data + (b.size - bytes);
    });
  }
};

/// Reads a control part of exactly this size. Refused, or all of the message's arrays lie inside the blocks
/// and every byte of it can be read.
template <class Stock>
void survive(const Received& received, const Bytes& control) {
  const std::unique_ptr<std::uint8_t[]> exact(new std::uint8_t[control.size()]);
  std::copy(control.begin(), control.end(), exact.get());
  const auto view = message::make_view<Stock>(exact.get(), control.size(), received.blocks, nullptr);
  if (!view) return;
  visit_arrays(*view,
               [&](const void* data, std::size_t bytes) { EXPECT_TRUE(received.contains(data, bytes)); });
  if (ros::serialization::serializationLength(*view) < (1u << 20)) wire_bytes(*view);
}

/// The control part cut at any byte, and with any byte changed. Of a very long one, 3000 places each.
template <class Stock>
void check_damage(const message::Encoded& encoded, unsigned seed) {
  const Received received(encoded);
  const Bytes& control = encoded.control;
  std::mt19937 random(seed);
  const std::size_t step = std::max<std::size_t>(1, control.size() / 3000);
  for (std::size_t i = random() % step; i < control.size(); i += step) {
    survive<Stock>(received, Bytes(control.begin(), control.begin() + static_cast<std::ptrdiff_t>(i)));
    Bytes flipped = control;
    flipped[i] ^= static_cast<std::uint8_t>(1 + random() % 255);
    survive<Stock>(received, flipped);
  }
}

/// control part + data part -> message is what it was, for a message that is sent as M.
template <class M, class Stock>
void check_partial(const M& message, const Bytes& bytes, unsigned seed) {
  const auto memory = std::make_shared<TestMemory>(std::size_t{4} << 20);
  message::Encoded encoded;
  ASSERT_TRUE(message::encode(message, memory, encoded));
  const auto blocks = blocks_of(encoded);
  const auto view =
      message::make_view<Stock>(encoded.control.data(), encoded.control.size(), blocks, nullptr);
  const auto copy = message::make_copy<Stock>(encoded.control.data(), encoded.control.size(), blocks);
  ASSERT_TRUE(view && copy);
  expect_same(*view, bytes);
  expect_same(*copy, bytes);
  if (seed < 2) check_damage<Stock>(encoded, seed);
}

template <class Stock, class Twin>
void check_twin(const Stock& stock, const Bytes& bytes, unsigned seed, std::false_type /* same type */) {
  check_wire<Twin, Stock>(stock, bytes);
  check_comparison<Twin>(stock, stock, Compares<Twin, Stock>());
  check_comparison<Twin>(stock, random_message<Stock>(seed + 1, 40), Compares<Twin, Stock>());
  check_comparison<Twin>(stock, Stock(), Compares<Twin, Stock>());
  check_partial<Twin, Stock>(Twin(stock), bytes, seed);
  const auto memory = std::make_shared<TestMemory>(std::size_t{4} << 20);
  Twin bound(stock);
  ASSERT_TRUE(message::allocate(bound, memory));
  EXPECT_LE(memory->allocations, 1) << "one buffer for the whole message when the sizes are known";
  message::Encoded encoded;
  ASSERT_TRUE(message::encode(bound, memory, encoded));
  EXPECT_EQ(encoded.copied_bytes, 0u) << "every data array was organized into shared memory";
  expect_same(static_cast<Stock>(bound), bytes);
}

template <class Stock, class Twin>
void check_twin(const Stock&, const Bytes&, unsigned, std::true_type /* same type */) {}

/// md5 and fixed_length are what our census says of the type; roscpp's header of it was made by gencpp.
template <class Twin, class Stock>
void check_type(const char* md5, bool fixed_length) {
  EXPECT_STREQ(ros::message_traits::MD5Sum<Stock>::value(), md5);
  EXPECT_EQ(bool(ros::message_traits::IsFixedSize<Stock>::value), fixed_length);
  check_traits<Twin, Stock>();
  for (unsigned seed = 0; seed < 4; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const auto stock = random_message<Stock>(seed, 40);
    const Bytes bytes = wire_bytes(stock);
    check_twin<Stock, Twin>(stock, bytes, seed, std::is_same<Stock, Twin>());
    check_partial<Stock, Stock>(stock, bytes, seed);
  }
}

}  // namespace test
}  // namespace tzc
