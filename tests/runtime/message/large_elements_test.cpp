// SPDX-License-Identifier: BSD-3-Clause
// Elements that are larger than a thread's stack.
#include <pthread.h>
#include <tzc/generated_message_support.h>

#include <array>
#include <functional>

#include "test_memory.h"

namespace tzc {
namespace {

/// As gencpp makes it of `uint8[4194304] pixels`: its constructor fills it.
struct Frame {
  Frame() { pixels.assign(0); }
  explicit Frame(std::uint8_t value) { pixels.assign(value); }
  boost::array<std::uint8_t, std::size_t{4} << 20> pixels;
};
static_assert(std::is_trivially_copyable<Frame>::value, "what an array takes");

void run_on_a_small_stack(const std::function<void()>& what) {
  pthread_attr_t attributes;
  ASSERT_EQ(0, ::pthread_attr_init(&attributes));
  ASSERT_EQ(0, ::pthread_attr_setstacksize(&attributes, std::size_t{1} << 20));
  pthread_t thread;
  const auto start = [](void* work) -> void* {
    (*static_cast<const std::function<void()>*>(work))();
    return nullptr;
  };
  ASSERT_EQ(0, ::pthread_create(&thread, &attributes, start, const_cast<std::function<void()>*>(&what)));
  ::pthread_join(thread, nullptr);
  ::pthread_attr_destroy(&attributes);
}

std::string values(const Array<Frame>& frames) {
  std::string text;
  for (const Frame& frame : frames) text += std::to_string(frame.pixels.front());
  return text;
}

}  // namespace
}  // namespace tzc

namespace ros {
namespace serialization {
template <>
struct Serializer<tzc::Frame> {
  template <class Stream, class Message>
  static void allInOne(Stream& stream, Message message) {
    stream.next(message.pixels);
  }
  ROS_DECLARE_ALLINONE_SERIALIZER
};
}  // namespace serialization
}  // namespace ros

namespace tzc {
namespace {

TEST(LargeElements, need_no_stack) {
  run_on_a_small_stack([] {
    Array<Frame> frames(2);
    frames.resize(3);
    EXPECT_EQ("000", values(frames));
    frames.emplace_back(std::uint8_t{1});
    frames.push_back(frames[3]);
    frames.insert(frames.begin(), frames[4]);
    frames.emplace(frames.begin() + 1, std::uint8_t{2});
    EXPECT_EQ("1200011", values(frames));
    frames.insert(frames.begin(), 1, frames[1]);
    frames.resize(9, frames[0]);
    EXPECT_EQ("212000112", values(frames));
    frames.assign(2, frames[1]);
    EXPECT_EQ("11", values(frames));
  });
}

TEST(LargeElements, are_serialized_without_one_on_the_stack) {
  run_on_a_small_stack([] {
    Array<Frame> frames, read;
    frames.emplace_back(std::uint8_t{3});
    const std::uint32_t length = ros::serialization::serializationLength(frames);
    std::vector<std::uint8_t> wire(length);
    ros::serialization::OStream out(wire.data(), length);
    ros::serialization::serialize(out, frames);
    ros::serialization::IStream in(wire.data(), length);
    ros::serialization::deserialize(in, read);
    EXPECT_EQ("3", values(read));
  });
}

}  // namespace
}  // namespace tzc
