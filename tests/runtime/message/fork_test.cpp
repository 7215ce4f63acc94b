// SPDX-License-Identifier: BSD-3-Clause
// What a forked child publishes of its parent's messages are the child's own bytes.
#include <sys/wait.h>
#include <tzc/message.h>
#include <tzc/sensor_msgs/Image.h>
#include <unistd.h>

#include <algorithm>
#include <functional>

#include "test_memory.h"

namespace tzc {
namespace message {
namespace {

using sensor_msgs::Image;

constexpr std::size_t size = 10'000;

Image image(std::uint8_t value) {
  Image message;
  message.data.assign(size, value);
  return message;
}

Encoded encoded(const Image& message, const std::shared_ptr<MemorySource>& memory) {
  Encoded result;
  EXPECT_TRUE(encode(message, memory, result));
  return result;
}

/// One buffer of this process with elements of that value.
bool is_own(const Encoded& message, std::uint8_t value) {
  if (message.buffers.size() != 1 || message.buffers[0]->inherited()) return false;
  const std::uint8_t* const elements = message.buffers[0]->data();
  return std::count(elements, elements + size, value) == size;
}

class InForkedChild : public ::testing::Test {
 protected:
  /// `body` gets memory of the child.
  static void run(const std::function<bool(const std::shared_ptr<MemorySource>&)>& body) {
    const pid_t child = ::fork();
    if (child == 0) ::_exit(body(std::make_shared<test::TestMemory>()) ? 0 : 1);
    int status = -1;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    EXPECT_EQ(status, 0) << "status " << status;
  }

  const std::shared_ptr<MemorySource> memory_ = std::make_shared<test::TestMemory>();
};

TEST_F(InForkedChild, elements_in_its_parents_memory_are_copied_each_time) {
  Image message = image(1);
  ASSERT_TRUE(allocate(message, memory_));
  run([&](const auto& own) {
    for (const std::uint8_t value : {2, 3}) {
      std::fill(message.data.begin(), message.data.end(), value);
      const Encoded sent = encoded(message, own);
      if (!is_own(sent, value) || sent.copied_bytes != size) return false;
    }
    return true;
  });
  EXPECT_FALSE(encoded(message, memory_).buffers[0]->inherited());
  EXPECT_EQ(image(1).data, message.data);
}

TEST_F(InForkedChild, elements_that_its_parent_published_are_copied) {
  Image message = image(1);
  ASSERT_TRUE(allocate(message, memory_));
  encoded(message, memory_);
  run([&](const auto& own) {
    const Image copy(message);
    const bool both = is_own(encoded(message, own), 1) && is_own(encoded(copy, own), 1);
    std::fill(message.data.begin(), message.data.end(), std::uint8_t{2});
    return both && is_own(encoded(message, own), 2) && is_own(encoded(copy, own), 1);
  });
}

TEST_F(InForkedChild, elements_on_the_heap_that_its_parent_published_are_copied_once) {
  Image message = image(1);
  const Encoded before = encoded(message, memory_);
  run([&](const auto& own) {
    const Encoded first = encoded(message, own), second = encoded(message, own);
    if (!is_own(first, 1) || first.copied_bytes != size || second.copied_bytes != 0) return false;
    std::fill(message.data.begin(), message.data.end(), std::uint8_t{2});
    return is_own(encoded(message, own), 2) && is_own(first, 1);
  });
  EXPECT_EQ(before.buffers, encoded(message, memory_).buffers);
}

TEST_F(InForkedChild, allocate_moves_elements_into_its_own_memory) {
  Image message = image(1);
  ASSERT_TRUE(allocate(message, memory_));
  run([&](const auto& own) {
    if (!allocate(message, own)) return false;
    const Encoded sent = encoded(message, own);
    return is_own(sent, 1) && sent.copied_bytes == 0;
  });
}

TEST_F(InForkedChild, callbacks_get_copies_of_its_parents_buffers) {
  const BufferPtr buffer = memory_->allocate(size);
  std::fill_n(buffer->data(), size, std::uint8_t{1});
  run([&](const auto&) {
    std::fill_n(buffer->data(), size, std::uint8_t{2});
    const BufferViews views = view_for_callbacks({buffer});
    return views.blocks[0].data != buffer->data() && views.blocks[0].data[size - 1] == 2;
  });
}

}  // namespace
}  // namespace message
}  // namespace tzc
