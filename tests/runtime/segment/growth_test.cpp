// SPDX-License-Identifier: BSD-3-Clause
// Memories without a given size: how they grow where the system has little, and what they give back.
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <fstream>
#include <memory>
#include <new>
#include <string>
#include <vector>

#include "tzc/memory.h"
#include "tzc/process_memory.h"

namespace tzc {
namespace segment {
namespace {

constexpr std::size_t mb = 1 << 20;

std::shared_ptr<SegmentMemory> growing_memory(std::size_t queue_size, Prefault prefault = Prefault::none) {
  MemoryOptions options;
  options.queue_size = queue_size;
  options.prefault = prefault;
  return *SegmentMemory::create(options);
}

std::vector<BufferPtr> fill(SegmentMemory& memory, std::size_t bytes) {
  std::vector<BufferPtr> buffers;
  while (BufferPtr buffer = memory.allocate(bytes)) buffers.push_back(buffer);
  return buffers;
}

struct Ceiling {
  explicit Ceiling(std::size_t bytes) { set_memory_ceiling(bytes); }
  ~Ceiling() { set_memory_ceiling(SIZE_MAX); }
};

// The pages of a segment are committed at once with Prefault::all, so a ceiling refuses the segment itself.
TEST(Growth, goes_down_to_what_the_system_has) {
  const auto memory = growing_memory(100, Prefault::all);
  const Ceiling ceiling(process_memory().reserved_bytes + 40 * mb);
  EXPECT_TRUE(memory->allocate(mb)) << memory->last_failure().text();
  EXPECT_GE(memory->stats().size_bytes, 8 * mb);
  EXPECT_LE(memory->stats().size_bytes, 22 * mb) << "the rest of the process keeps half";
}

TEST(Growth, goes_down_to_one_message) {
  const auto memory = growing_memory(100, Prefault::all);
  const Ceiling ceiling(process_memory().reserved_bytes + mb + mb / 4);
  const BufferPtr one = memory->allocate(mb);
  EXPECT_TRUE(one) << memory->last_failure().text();
  EXPECT_FALSE(memory->allocate(mb));
  EXPECT_EQ(memory->last_failure().cause, AllocationError::Cause::system);
}

TEST(Growth, is_as_it_was_when_memory_comes_back) {
  const auto memory = growing_memory(100, Prefault::all);
  std::vector<BufferPtr> held;
  {
    const Ceiling ceiling(process_memory().reserved_bytes + mb);
    held = fill(*memory, mb / 10);
    EXPECT_GE(held.size(), 2u);
    EXPECT_LE(held.size(), 8u);
  }
  for (int i = 0; i < 200; ++i) {
    if (BufferPtr buffer = memory->allocate(mb / 10)) held.push_back(buffer);
  }
  EXPECT_GE(held.size(), 150u);
}

// A message that needs less than what was refused is not kept from asking.
TEST(Growth, a_small_message_is_not_refused_for_a_large_one) {
  const auto memory = growing_memory(0, Prefault::all);
  const Ceiling ceiling(process_memory().reserved_bytes + 4 * mb);
  EXPECT_FALSE(memory->allocate(16 * mb));
  EXPECT_TRUE(memory->allocate(1000)) << memory->last_failure().text();
}

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
// In kB whatever the size of a page is, or seems to be.
std::size_t address_space() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    std::size_t kilobytes = 0;
    if (std::sscanf(line.c_str(), "VmSize: %zu kB", &kilobytes) == 1) return kilobytes << 10;
  }
  return 0;
}

// Images of 4 MB, a queue of 100, 200 MB of address space: the first segment would be one of 408 MB.
bool shares_address_space() {
  const auto memory = growing_memory(100);
  const rlim_t most = address_space() + 200 * mb;
  const rlimit limit{most, most};
  if (::setrlimit(RLIMIT_AS, &limit) != 0) return false;
  const std::vector<BufferPtr> held = fill(*memory, 4 * mb);
  const bool refused_by_system = memory->last_failure().cause == AllocationError::Cause::system;
  const std::unique_ptr<char[]> serialized(new (std::nothrow) char[32 * mb]);
  std::fprintf(stderr, "%zu messages, %s\n", held.size(), memory->last_failure().text().c_str());
  return held.size() >= 8 && refused_by_system && serialized != nullptr;
}

TEST(Growth, shares_the_address_space_with_the_program_in_a_child) {
  const pid_t child = ::fork();
  if (child == 0) ::_exit(shares_address_space() ? 0 : 1);
  int status = -1;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  EXPECT_EQ(status, 0) << "status " << status;
}
#endif

/// A small message that is kept, so that its segment stays, beside one for large messages.
class IdleSegments : public ::testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(kept_ && memory_->allocate(large));
    ASSERT_EQ(memory_->stats().segments, 2u);
  }
  void publish_small(int count) {
    for (int i = 0; i < count; ++i) ASSERT_TRUE(memory_->allocate(small));
  }

  static constexpr std::size_t small = 1000, large = 8 * mb;
  const std::shared_ptr<SegmentMemory> memory_ = growing_memory(10);
  const BufferPtr kept_ = memory_->allocate(small);
};

TEST_F(IdleSegments, are_given_back) {
  const std::size_t before = process_memory().reserved_bytes;
  publish_small(1000);
  EXPECT_EQ(memory_->stats().segments, 1u);
  EXPECT_LE(process_memory().reserved_bytes, before - large);
  EXPECT_TRUE(kept_);
}

TEST_F(IdleSegments, stay_where_large_and_small_messages_alternate) {
  const std::uint8_t* const place = memory_->allocate(large)->data();
  for (int i = 0; i < 20; ++i) {
    publish_small(500);
    ASSERT_EQ(memory_->allocate(large)->data(), place) << i;
  }
  EXPECT_EQ(memory_->stats().segments, 2u);
}

TEST_F(IdleSegments, stay_while_a_message_lies_there) {
  const BufferPtr held = memory_->allocate(large);
  publish_small(3000);
  EXPECT_EQ(memory_->stats().segments, 2u);
}

TEST_F(IdleSegments, come_back_as_large_as_at_first) {
  const std::size_t before = memory_->stats().size_bytes;
  publish_small(1000);
  ASSERT_EQ(memory_->stats().segments, 1u);
  EXPECT_TRUE(memory_->allocate(large));
  EXPECT_GE(memory_->stats().size_bytes, before);
}

TEST_F(IdleSegments, the_last_one_stays) {
  publish_small(10'000);
  EXPECT_EQ(memory_->stats().segments, 1u);
}

class LargeSegments : public ::testing::Test {
 protected:
  void publish_small(int count) {
    for (int i = 0; i < count; ++i) ASSERT_TRUE(memory_->allocate(1000));
  }

  static constexpr std::size_t large = 32 * mb;
  const std::shared_ptr<SegmentMemory> memory_ = growing_memory(10);
};

TEST_F(LargeSegments, are_left_when_messages_have_long_been_small) {
  ASSERT_TRUE(memory_->allocate(large));
  publish_small(3000);
  EXPECT_EQ(memory_->stats().segments, 1u);
  EXPECT_LE(memory_->stats().reserved_bytes, 2 * mb);
}

TEST_F(LargeSegments, are_left_also_where_the_large_message_came_later) {
  publish_small(100);
  ASSERT_TRUE(memory_->allocate(large));
  publish_small(3000);
  EXPECT_EQ(memory_->stats().segments, 1u);
  EXPECT_LE(memory_->stats().reserved_bytes, 2 * mb);
}

TEST_F(LargeSegments, are_left_where_one_is_as_large_as_the_ceiling) {
  ASSERT_TRUE(memory_->allocate(160 * mb));
  ASSERT_GE(memory_->stats().size_bytes, std::size_t{1} << 30);
  publish_small(5000);
  EXPECT_EQ(memory_->stats().segments, 1u);
  EXPECT_LE(memory_->stats().size_bytes, 32 * mb);
}

TEST_F(LargeSegments, go_only_when_the_last_message_there_has_gone) {
  BufferPtr held = memory_->allocate(large);
  const std::uint8_t* const place = held->data();
  publish_small(100);  // beside it
  held = memory_->allocate(1000);
  publish_small(4000);
  EXPECT_EQ(memory_->stats().segments, 2u);
  EXPECT_NE(memory_->allocate(1000)->data(), place);
  held.reset();
  publish_small(200);
  EXPECT_EQ(memory_->stats().segments, 1u);
}

TEST_F(LargeSegments, stay_where_large_and_small_messages_alternate) {
  const std::uint8_t* const place = memory_->allocate(large)->data();
  for (int i = 0; i < 20; ++i) {
    publish_small(500);
    ASSERT_EQ(memory_->allocate(large)->data(), place) << i;
  }
}

TEST_F(LargeSegments, stay_while_that_much_is_used) {
  const BufferPtr held = memory_->allocate(large);
  publish_small(5000);
  EXPECT_EQ(memory_->stats().segments, 1u);
}

}  // namespace
}  // namespace segment
}  // namespace tzc
