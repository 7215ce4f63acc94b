// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstring>
#include <thread>
#include <vector>

#include "tzc/memory.h"

namespace tzc {
namespace {

constexpr std::size_t mb = 1 << 20;

std::shared_ptr<SegmentMemory> memory_of(std::size_t size, Policy policy = Policy()) {
  MemoryOptions options;
  options.size = size;
  options.policy = policy;
  options.name = "test";
  auto memory = SegmentMemory::create(options);
  EXPECT_TRUE(memory) << memory.error().text();
  return *memory;
}

std::vector<BufferPtr> fill_up(SegmentMemory& memory, std::size_t bytes) {
  std::vector<BufferPtr> buffers;
  while (BufferPtr buffer = memory.allocate(bytes)) buffers.push_back(buffer);
  return buffers;
}

TEST(Memory, ABufferIsAlignedLargeEnoughAndUnsealed) {
  const auto memory = memory_of(4 * mb);
  for (const std::size_t bytes : {0, 1, 63, 64, 65, 4096, 100'000}) {
    const BufferPtr buffer = memory->allocate(bytes);
    ASSERT_TRUE(buffer);
    EXPECT_GE(buffer->size(), std::max<std::size_t>(bytes, 1));
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(buffer->data()) % 64, 0u);
    EXPECT_FALSE(buffer->sealed());
    std::memset(buffer->data(), 1, buffer->size());
  }
}

TEST(Memory, HoldsAsManyMessagesAsItsSizeSays) {
  EXPECT_EQ(fill_up(*memory_of(16 * mb), mb).size(), 16u);
  EXPECT_EQ(fill_up(*memory_of(mb), 4096).size(), 256u);
  EXPECT_EQ(fill_up(*memory_of(4096), 4096).size(), 1u);
}

TEST(Memory, AReleasedBlockIsReusedWhileItIsHot) {
  const auto memory = memory_of(64 * mb);
  const std::uint8_t* first = memory->allocate(4 * mb)->data();
  for (int i = 0; i < 10; ++i) EXPECT_EQ(memory->allocate(4 * mb)->data(), first);
  EXPECT_LT(memory->stats().reserved_bytes, 5 * mb);
}

TEST(Memory, ASealedBlockIsReclaimedToo) {
  const auto memory = memory_of(2 * mb);
  memory->allocate(mb)->seal();
  for (int i = 0; i < 10; ++i) {
    const BufferPtr buffer = memory->allocate(mb);
    ASSERT_TRUE(buffer);
    EXPECT_FALSE(buffer->sealed());
    buffer->seal();
  }
}

TEST(Memory, IsSparse) {
  const auto memory = memory_of(std::size_t{64} << 30);
  ASSERT_TRUE(memory->allocate(100));
  EXPECT_LE(memory->stats().reserved_bytes, 8192u);
  EXPECT_GE(memory->stats().size_bytes, std::size_t{64} << 30);
}

TEST(Memory, ExhaustedIsNullWithAReason) {
  const auto memory = memory_of(mb);
  const BufferPtr all = memory->allocate(mb);
  EXPECT_FALSE(memory->allocate(mb));
  EXPECT_FALSE(memory->allocate(SIZE_MAX));
  EXPECT_EQ(memory->stats().refused, 2u);
  EXPECT_NE(memory->last_failure().text().find("more memory"), std::string::npos)
      << memory->last_failure().text();
}

TEST(Memory, SizeZeroSizesItselfAndGrows) {
  MemoryOptions options;
  options.queue_size = 3;
  options.ceiling = 64 * mb;
  const auto memory = *SegmentMemory::create(options);
  EXPECT_EQ(memory->stats().segments, 0u);
  std::vector<BufferPtr> held{memory->allocate(mb)};
  EXPECT_EQ(memory->stats().segments, 1u);
  EXPECT_GE(memory->stats().size_bytes, 5 * mb);
  EXPECT_LT(memory->stats().size_bytes, 6 * mb);
  for (int i = 0; i < 10; ++i) held.push_back(memory->allocate(mb));
  EXPECT_TRUE(held.back());
  EXPECT_GT(memory->stats().segments, 1u);
  for (BufferPtr& more : fill_up(*memory, mb)) held.push_back(more);
  EXPECT_LE(memory->stats().size_bytes, 70 * mb);
  EXPECT_GE(held.size(), 50u);
}

TEST(Memory, SizeZeroFollowsMessagesThatGrow) {
  MemoryOptions options;
  options.ceiling = 64 * mb;
  const auto memory = *SegmentMemory::create(options);
  for (const std::size_t bytes : {std::size_t{1000}, mb, 4 * mb, 12 * mb})
    EXPECT_TRUE(memory->allocate(bytes)) << bytes;
  EXPECT_EQ(memory->stats().segments, 1u) << "segments that became too small are let go";
}

TEST(Memory, ABufferOutlivesItsMemory) {
  auto memory = memory_of(mb);
  const BufferPtr buffer = memory->allocate(1000);
  memory.reset();
  std::memset(buffer->data(), 5, buffer->size());
  EXPECT_TRUE(in_segment(buffer->data()));
}

TEST(Memory, FindsTheBufferOfAnAddress) {
  const auto memory = memory_of(mb);
  const BufferPtr buffer = memory->allocate(1000);
  const BufferPtr other = memory->allocate(1000);
  EXPECT_EQ(find_buffer(buffer->data(), 1000), buffer);
  EXPECT_EQ(find_buffer(buffer->data() + 999, 1), buffer);
  EXPECT_EQ(find_buffer(other->data(), other->size()), other);
  EXPECT_FALSE(find_buffer(buffer->data(), buffer->size() + 1));
  EXPECT_FALSE(find_buffer(buffer->data() - 1, 1));
  EXPECT_FALSE(find_buffer(&memory, 1));
  EXPECT_FALSE(in_segment(&memory));
}

TEST(Memory, DoesNotFindWhatNobodyHolds) {
  const auto memory = memory_of(mb);
  const std::uint8_t* address = memory->allocate(1000)->data();
  EXPECT_FALSE(find_buffer(address, 1));
}

TEST(Memory, PrefaultAllReservesEverything) {
  MemoryOptions options;
  options.size = 4 * mb;
  options.prefault = Prefault::all;
  const auto memory = *SegmentMemory::create(options);
  EXPECT_GE(memory->stats().reserved_bytes, 4 * mb);
}

TEST(Memory, AForkedChildCanReadButNotAllocate) {
  const auto memory = memory_of(mb);
  const BufferPtr buffer = memory->allocate(1000);
  buffer->data()[0] = 77;
  const pid_t child = ::fork();
  if (child == 0) {
    const bool reads = buffer->data()[0] == 77;
    ::_exit(reads && !memory->allocate(1) && !find_buffer(buffer->data(), 1) ? 0 : 1);
  }
  int status = -1;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  EXPECT_EQ(status, 0);
  EXPECT_TRUE(memory->allocate(1));
}

TEST(Memory, ThreadsMayAllocateConcurrently) {
  const auto memory = memory_of(8 * mb);
  const auto work = [&memory](unsigned char mark) {
    for (int i = 0; i < 5'000; ++i) {
      const BufferPtr buffer = memory->allocate(1000 + i % 3000);
      ASSERT_TRUE(buffer);
      std::memset(buffer->data(), mark, 1000);
      ASSERT_EQ(find_buffer(buffer->data() + 500, 10), buffer);
      ASSERT_EQ(buffer->data()[999], mark);
    }
  };
  std::vector<std::thread> threads;
  for (unsigned char mark = 1; mark <= 4; ++mark) threads.emplace_back(work, mark);
  for (std::thread& thread : threads) thread.join();
}

}  // namespace
}  // namespace tzc
