// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <set>
#include <thread>
#include <vector>

#include "posix/fork_epoch.h"
#include "segment/memory_pool.h"
#include "segment/received_segment.h"
#include "segment/segment.h"
#include "tzc/memory.h"
#include "tzc/process_memory.h"

namespace tzc {
namespace {

constexpr std::size_t mib = 1 << 20;

std::shared_ptr<SegmentMemory> pooled_memory(std::size_t size, const char* name = "pooled") {
  MemoryOptions options;
  options.size = size;
  options.name = name;
  options.pooled = true;
  auto memory = SegmentMemory::create(options);
  EXPECT_TRUE(memory) << memory.error().text();
  return *memory;
}

segment::SegmentPtr pooled_segment(std::size_t size) {
  MemoryOptions options;
  options.pooled = true;
  return *segment::Segment::create(size, options);
}

/// The kernel gives the lowest number that is free.
int lowest_free_descriptor() {
  const int number = ::dup(STDIN_FILENO);
  ::close(number);
  return number;
}

std::size_t committed_bytes_of(int fd) {
  struct stat status{};
  EXPECT_EQ(::fstat(fd, &status), 0);
  return static_cast<std::size_t>(status.st_blocks) * 512;
}

int status_of(pid_t child) {
  int status = -1;
  EXPECT_EQ(::waitpid(child, &status, 0), child);
  return status;
}

/// Tests of what a system without such files does not have.
class Pool : public testing::Test {
 protected:
  void SetUp() override {
    if (!segment::MemoryPool::of_process()) GTEST_SKIP() << "each segment has a file of its own here";
  }
};

TEST(PooledMemory, works_where_there_is_no_pool_too) {
  const auto memory = pooled_memory(mib);
  const BufferPtr buffer = memory->allocate(1000);
  ASSERT_TRUE(buffer);
  std::memset(buffer->data(), 1, buffer->size());
  EXPECT_EQ(find_buffer(buffer->data(), 1), buffer);
}

TEST_F(Pool, a_hundred_memories_take_two_descriptors) {
  const auto first = pooled_memory(mib);
  const int before = lowest_free_descriptor();
  std::vector<std::shared_ptr<SegmentMemory>> others;
  for (int i = 0; i < 100; ++i) others.push_back(pooled_memory(mib));
  EXPECT_EQ(lowest_free_descriptor(), before);
  std::set<const void*> payloads;
  for (const auto& memory : others) payloads.insert(memory->allocate(1000)->data());
  EXPECT_EQ(payloads.size(), others.size());
}

TEST_F(Pool, two_descriptors_are_all_and_go_with_the_last_memory) {
  const int before = lowest_free_descriptor();
  auto memory = pooled_memory(mib);
  const auto other = pooled_memory(mib);
  EXPECT_GE(lowest_free_descriptor(), before);
  EXPECT_LE(lowest_free_descriptor(), before + 2);
  memory.reset();
  EXPECT_TRUE(other->allocate(1000));
}

TEST_F(Pool, what_one_memory_writes_no_other_one_sees) {
  const auto one = pooled_memory(mib), other = pooled_memory(mib);
  const BufferPtr ones = one->allocate(mib / 2), others = other->allocate(mib / 2);
  std::memset(ones->data(), 1, ones->size());
  std::memset(others->data(), 2, others->size());
  EXPECT_EQ(std::count(ones->data(), ones->data() + ones->size(), 1), static_cast<long>(ones->size()));
  EXPECT_EQ(std::count(others->data(), others->data() + others->size(), 2),
            static_cast<long>(others->size()));
}

TEST_F(Pool, gets_the_pages_of_a_memory_back_and_shows_none_of_them_again) {
  const auto stays = pooled_memory(mib);
  const auto pool = segment::MemoryPool::of_process();
  const std::size_t before = committed_bytes_of(pool->file().shared_fd());
  const std::size_t reserved = process_memory().reserved_bytes;
  {
    const auto memory = pooled_memory(8 * mib);
    const BufferPtr buffer = memory->allocate(4 * mib);
    std::memset(buffer->data(), 7, buffer->size());
    EXPECT_GE(committed_bytes_of(pool->file().shared_fd()), before + 4 * mib);
    EXPECT_GE(process_memory().reserved_bytes, reserved + 4 * mib);
  }
  EXPECT_EQ(committed_bytes_of(pool->file().shared_fd()), before);
  EXPECT_EQ(process_memory().reserved_bytes, reserved);
  const auto next = pooled_memory(8 * mib);
  const BufferPtr buffer = next->allocate(4 * mib);
  EXPECT_EQ(std::count(buffer->data(), buffer->data() + buffer->size(), 0), static_cast<long>(4 * mib));
}

TEST_F(Pool, peers_read_their_part_and_cannot_write_through_what_they_get) {
  const segment::SegmentPtr first = pooled_segment(mib), second = pooled_segment(mib);
  const segment::SegmentPages& pages = second->file().pages();
  EXPECT_EQ(pages.fd(), first->file().pages().fd());
  EXPECT_NE(pages.offset(), first->file().pages().offset());
  const auto theirs =
      posix::Mapping::map(pages.fd(), second->file().size(), posix::Access::read_only, pages.offset());
  ASSERT_TRUE(theirs);
  std::uint64_t id = 0;
  std::memcpy(&id, theirs->data() + offsetof(segment::SegmentHeader, id), sizeof id);
  EXPECT_EQ(id, second->id());
  EXPECT_FALSE(
      posix::Mapping::map(pages.fd(), second->file().size(), posix::Access::read_write, pages.offset()));
  EXPECT_NE(::ftruncate(pages.fd(), 0), 0);
  const std::string again = "/proc/self/fd/" + std::to_string(pages.fd());
  struct stat status{};
  ASSERT_EQ(::stat(again.c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777, unsigned{S_IRUSR}) << "another process could open it for writing";
  EXPECT_TRUE(posix::check_received(pages.fd(), pages.file_size(), posix::Sharing::peers_read));
}

TEST_F(Pool, a_forked_child_changes_nothing_of_its_parents) {
  auto memory = pooled_memory(mib);
  const BufferPtr buffer = memory->allocate(100'000);
  std::memset(buffer->data(), 7, buffer->size());
  const pid_t child = ::fork();
  if (child == 0) {
    std::memset(buffer->data(), 8, buffer->size());
    memory.reset();
    const auto own = pooled_memory(mib, "child");  // of a pool of its own
    ::_exit(own->allocate(1000) ? 0 : 1);
  }
  EXPECT_EQ(status_of(child), 0);
  EXPECT_EQ(std::count(buffer->data(), buffer->data() + 100'000, 7), 100'000);
}

/// The child destroys the last reference to a part; its parent goes on using it.
TEST_F(Pool, a_forked_child_gives_no_pages_of_its_parent_back) {
  segment::SegmentPtr segment = pooled_segment(mib);
  Error failure;
  segment::Block* const block = segment->allocate_block(8192, segment::Segment::Where::anywhere, failure);
  ASSERT_NE(block, nullptr);
  BufferPtr buffer = block->handle();
  std::memset(buffer->data(), 7, 8192);
  const pid_t child = ::fork();
  if (child == 0) {
    buffer.reset();
    segment = segment::SegmentPtr();
    ::_exit(0);
  }
  EXPECT_EQ(status_of(child), 0);
  EXPECT_EQ(std::count(buffer->data(), buffer->data() + 8192, 7), 8192);
}

TEST_F(Pool, a_limit_on_file_sizes_leaves_each_memory_a_file_of_its_own) {
  const pid_t child = ::fork();
  if (child == 0) {
    const rlimit limit{64 * mib, 64 * mib};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    const auto memory = pooled_memory(mib);
    ::_exit(!segment::MemoryPool::of_process() && memory->allocate(1000) ? 0 : 1);
  }
  EXPECT_EQ(status_of(child), 0);
}

TEST_F(Pool, memories_come_and_go_on_many_threads) {
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t)
    threads.emplace_back([t] {
      for (int i = 0; i < 200; ++i) {
        const auto memory = pooled_memory((1 + (i + t) % 5) * mib / 4);
        const BufferPtr buffer = memory->allocate(mib / 8);
        ASSERT_TRUE(buffer);
        EXPECT_EQ(buffer->data()[i], 0);
        std::memset(buffer->data(), t + 1, buffer->size());
        EXPECT_EQ(std::count(buffer->data(), buffer->data() + buffer->size(), t + 1),
                  static_cast<long>(buffer->size()));
      }
    });
  for (std::thread& thread : threads) thread.join();
}

}  // namespace
}  // namespace tzc
