// SPDX-License-Identifier: BSD-3-Clause
// What callbacks of the publisher's process see, and what becomes of their writes.
#include <tzc/message.h>
#include <tzc/sensor_msgs/Image.h>
#include <tzc/sensor_msgs/LaserScan.h>

#include <algorithm>
#include <thread>

#include "random_message.h"
#include "test_memory.h"

namespace tzc {
namespace message {
namespace {

namespace stock = ::sensor_msgs;
using sensor_msgs::Image;

class CallbackView : public ::testing::Test {
 protected:
  Image image(std::size_t bytes, std::uint8_t value = 1) {
    Image message;
    EXPECT_TRUE(allocate(message, memory_));
    message.data.assign(bytes, value);
    return message;
  }
  boost::shared_ptr<const stock::Image> view_of(const Image& message) {
    Encoded encoded;
    EXPECT_TRUE(encode(message, memory_, encoded));
    return callback_view(message, encoded);
  }
  static void write(const stock::Image& view) {
    auto& data = const_cast<stock::Image&>(view).data;
    std::fill(data.begin(), data.end(), 9);
  }
  static bool is_all(const std::uint8_t* data, std::size_t size, std::uint8_t value) {
    return std::all_of(data, data + size, [value](std::uint8_t byte) { return byte == value; });
  }
  static bool is_all(const Image& message, std::uint8_t value) {
    return is_all(message.data.data(), message.data.size(), value);
  }
  static bool is_all(const stock::Image& message, std::uint8_t value) {
    return is_all(message.data.data(), message.data.size(), value);
  }

  std::shared_ptr<test::TestMemory> memory_ = std::make_shared<test::TestMemory>(std::size_t{16} << 20);
};

TEST_F(CallbackView, a_write_reaches_neither_the_message_nor_other_processes) {
  for (const std::size_t bytes : {std::size_t{100}, std::size_t{4096}, std::size_t{100000}}) {
    const Image message = image(bytes);
    const auto view = view_of(message);
    EXPECT_TRUE(is_all(*view, 1));
    write(*view);
    EXPECT_TRUE(is_all(*view, 9)) << bytes;
    EXPECT_TRUE(is_all(message, 1)) << bytes;
    EXPECT_TRUE(is_all(message.data.buffer()->data(), bytes, 1)) << bytes << ": what subscribers read";
  }
}

TEST_F(CallbackView, what_is_published_again_shows_nothing_of_a_write_to_the_first) {
  const Image message = image(100000);
  const auto first = view_of(message);
  write(*first);
  const auto second = view_of(message);
  EXPECT_TRUE(is_all(*second, 1));
  const auto third = view_of(message);
  write(*second);
  EXPECT_TRUE(is_all(*third, 1));
}

TEST_F(CallbackView, an_array_beside_one_that_was_written_to_is_shown_as_it_is) {
  sensor_msgs::LaserScan scan;
  scan.ranges.resize(2000, 1);
  scan.intensities.reserve(2000);
  ASSERT_TRUE(allocate(scan, memory_));
  Encoded encoded;
  ASSERT_TRUE(encode(scan, memory_, encoded));
  const auto first = callback_view(scan, encoded);
  const_cast<stock::LaserScan&>(*first).ranges[0] = 9;
  scan.intensities.resize(2000, 5);
  ASSERT_TRUE(encode(scan, memory_, encoded));
  EXPECT_EQ(std::vector<float>(2000, 5), callback_view(scan, encoded)->intensities);
}

TEST_F(CallbackView, a_later_view_shows_what_was_published) {
  const Image message = image(100000);
  write(*view_of(message));
  EXPECT_TRUE(is_all(*view_of(message), 1));
}

TEST_F(CallbackView, a_block_that_is_used_again_shows_the_new_message) {
  const std::uint8_t* first = nullptr;
  {
    const Image message = image(100000);
    first = message.data.buffer()->data();
    write(*view_of(message));
  }
  const Image message = image(100000, 2);
  EXPECT_EQ(first, message.data.buffer()->data());
  EXPECT_TRUE(is_all(*view_of(message), 2));
}

TEST_F(CallbackView, is_published_without_a_copy_until_it_is_written_to) {
  const Image message = image(100000);
  const auto view = view_of(message);
  Encoded again;
  ASSERT_TRUE(encode(*view, memory_, again));
  EXPECT_EQ(0u, again.copied_bytes);
  EXPECT_EQ(message.data.buffer(), again.buffers.at(0));
  EXPECT_TRUE(is_all(*stock_view(*view, again), 1));
  write(*view);
  ASSERT_TRUE(encode(*view, memory_, again));
  EXPECT_EQ(100000u, again.copied_bytes);
  EXPECT_TRUE(is_all(*stock_view(*view, again), 9));
}

TEST_F(CallbackView, outlives_message_and_memory) {
  boost::shared_ptr<const stock::Image> view;
  {
    const Image message = image(100000);
    view = view_of(message);
    memory_.reset();
  }
  write(*view);
  EXPECT_TRUE(is_all(*view, 9));
}

TEST_F(CallbackView, views_come_and_go_on_all_threads) {
  const Image message = image(20000);
  const auto see = [&] {
    for (int i = 0; i < 2000; ++i) {
      const auto view = view_of(message);
      Encoded again;
      EXPECT_TRUE(encode(*view, memory_, again));
      EXPECT_TRUE(is_all(*view, 1));
    }
  };
  std::thread other(see);
  see();
  other.join();
}

}  // namespace
}  // namespace message
}  // namespace tzc
