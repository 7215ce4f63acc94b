// SPDX-License-Identifier: BSD-3-Clause
// What several threads may do with a std::vector at once, they may do with an array that was published: write to different
// elements, read, copy, publish. roscpp-tsan runs this with ThreadSanitizer, too.
#include <tzc/message.h>
#include <tzc/sensor_msgs/Image.h>

#include <algorithm>
#include <atomic>
#include <functional>
#include <thread>
#include <vector>

#include "random_message.h"
#include "test_memory.h"

namespace tzc {
namespace message {
namespace {

using sensor_msgs::Image;

constexpr std::size_t threads = 4, share = 5000, bytes = threads * share;

/// Runs work(0) to work(threads - 1) at once.
void in_threads(const std::function<void(std::size_t)>& work) {
  std::atomic<std::size_t> waiting{threads};
  std::vector<std::thread> all;
  for (std::size_t i = 0; i < threads; ++i)
    all.emplace_back([&, i] {
      for (--waiting; waiting != 0;) std::this_thread::yield();
      work(i);
    });
  for (std::thread& thread : all) thread.join();
}

class Threads : public ::testing::Test {
 protected:
  Threads() {
    image_.data.resize(bytes);
    EXPECT_TRUE(allocate(image_, memory_));
  }
  boost::shared_ptr<const ::sensor_msgs::Image> published(const Image& image) const {
    Encoded encoded;
    EXPECT_TRUE(encode(image, memory_, encoded));
    return stock_view(image, encoded);
  }

  std::shared_ptr<test::TestMemory> memory_ = std::make_shared<test::TestMemory>();
  Image image_;
};

/// A parallel loop over the pixels of a message that is a member.
TEST_F(Threads, write_different_elements_of_a_published_array) {
  for (int round = 0; round < 300; ++round) {
    const auto view = published(image_);
    const int copies = memory_->allocations;
    in_threads([&](std::size_t thread) {
      for (std::size_t i = 0; i < share; ++i) image_.data[thread * share + i] = round + thread;
    });
    EXPECT_EQ(copies + 1, memory_->allocations) << "one copy for all threads";
    for (std::size_t i = 0; i < bytes; ++i) {
      ASSERT_EQ(static_cast<std::uint8_t>(round + i / share), image_.data[i]);
      ASSERT_EQ(static_cast<std::uint8_t>(round == 0 ? 0 : round - 1 + i / share), view->data[i]);
    }
  }
}

TEST_F(Threads, read_what_they_got_at_before_another_one_writes) {
  for (int round = 0; round < 100; ++round) {
    std::fill(image_.data.begin(), image_.data.end(), round);
    published(image_);
    std::atomic<std::size_t> looking{0}, wrong{0};
    in_threads([&](std::size_t thread) {
      if (thread == 0) {
        while (looking != threads - 1) std::this_thread::yield();
        image_.data[0] = 255;
        const BufferPtr other = memory_->allocate(bytes);  // would lie where the elements were
        std::fill_n(other->data(), bytes, 254);
        return;
      }
      const Image& constant = image_;
      const std::uint8_t* const elements = constant.data.data();
      ++looking;
      for (int look = 0; look < 20; ++look)
        for (std::size_t i = 1; i < bytes; i += 100) wrong += elements[i] != static_cast<std::uint8_t>(round);
    });
    EXPECT_EQ(0u, wrong);
  }
}

/// An element that is only read is reached through operator[] of a message that is not const, too.
TEST_F(Threads, read_while_others_publish_and_copy) {
  std::fill(image_.data.begin(), image_.data.end(), 7);
  in_threads([&](std::size_t thread) {
    for (int round = 0; round < 100; ++round) {
      if (thread % 2 == 0) {
        EXPECT_EQ(7, image_.data[round]);
        continue;
      }
      const Image copy(image_);
      EXPECT_EQ(7, published(image_)->data[bytes - 1]);
      EXPECT_EQ(7, published(copy)->data[round]);
    }
  });
}

/// A map that is filled once: nobody writes, so nobody locks.
TEST_F(Threads, publish_and_read_a_message_that_was_never_allocated) {
  for (int round = 0; round < 100; ++round) {
    Image map;
    map.data.assign(bytes, 7);
    const Image& constant = map;
    in_threads([&](std::size_t thread) {
      if (thread % 2 == 0) {
        for (int i = 0; i < 3; ++i) EXPECT_EQ(7, published(map)->data[i]);
        return;
      }
      for (int i = 0; i < 3; ++i)
        EXPECT_EQ(static_cast<std::ptrdiff_t>(bytes),
                  std::count(constant.data.begin(), constant.data.end(), 7));
    });
  }
}

TEST_F(Threads, publish_and_copy_one_message) {
  std::fill(image_.data.begin(), image_.data.end(), 7);
  const Image& shared = image_;
  in_threads([&](std::size_t) {
    for (int round = 0; round < 50; ++round) {
      const auto view = published(shared);
      Image copy(shared);
      copy.data[0] = 99;
      EXPECT_EQ(7, view->data[0]);
    }
  });
  EXPECT_EQ(static_cast<std::ptrdiff_t>(bytes), std::count(shared.data.begin(), shared.data.end(), 7));
}

}  // namespace
}  // namespace message
}  // namespace tzc
