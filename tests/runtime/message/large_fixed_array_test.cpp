// SPDX-License-Identifier: BSD-3-Clause
// An array of fixed size lies in the message itself, which may be larger than the stack of the thread that reads it.
#include <gtest/gtest.h>
#include <ros/serialization.h>
#include <tzc/message.h>

#include <boost/array.hpp>
#include <memory>
#include <vector>

#include "test_memory.h"

namespace {

template <class Allocator>
struct Film_ {
  boost::array<std::uint8_t, (32 << 20)> fixed;
  std::vector<std::uint8_t> data;
};
using Film = Film_<std::allocator<void>>;

}  // namespace

namespace ros {
namespace serialization {

template <class Allocator>
struct Serializer<Film_<Allocator>> {
  template <class Stream, class T>
  static void allInOne(Stream& stream, T film) {
    stream.next(film.fixed);
    stream.next(film.data);
  }
  ROS_DECLARE_ALLINONE_SERIALIZER
};

}  // namespace serialization
}  // namespace ros

namespace tzc {
namespace message {
namespace {

TEST(LargeFixedArray, what_roscpp_serialized_is_not_read_onto_the_stack) {
  const auto film = std::make_unique<Film>();
  film->fixed.fill(1);
  film->data.assign(100, 2);
  const ros::SerializedMessage wire = ros::serialization::serializeMessage(*film);
  Encoded encoded;
  ASSERT_TRUE(encode_serialized<Film>(wire.message_start, wire.num_bytes - 4,
                                      std::make_shared<test::TestMemory>(), encoded));
  EXPECT_EQ(encoded.copied_bytes, 100u);
}

}  // namespace
}  // namespace message
}  // namespace tzc
