// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstring>
#include <map>
#include <thread>
#include <vector>

#include "sync_point/sync_point.h"
#include "tzc/memory.h"
#include "tzc/process_memory.h"

namespace tzc {
namespace {

std::size_t page_size() {
  return static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

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

TEST(Memory, a_buffer_is_aligned_large_enough_and_unsealed) {
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

TEST(Memory, a_payload_of_a_page_or_more_shares_no_page) {
  const auto memory = memory_of(4 * mb);
  const std::size_t page = page_size();
  std::vector<BufferPtr> held;
  std::map<std::uintptr_t, std::size_t> owners;  // page -> buffer
  for (const std::size_t bytes :
       {std::size_t{100}, page, std::size_t{50}, page + 1, 3 * page - 7, std::size_t{900}}) {
    held.push_back(memory->allocate(bytes));
    const auto begin = reinterpret_cast<std::uintptr_t>(held.back()->data());
    EXPECT_TRUE(bytes < page || begin % page == 0) << bytes;
    for (std::uintptr_t at = begin / page; at <= (begin + bytes - 1) / page; ++at) {
      const auto [entry, is_new] = owners.emplace(at, bytes);
      EXPECT_TRUE(is_new || (bytes < page && entry->second < page)) << bytes << " and " << entry->second;
    }
  }
}

TEST(Memory, holds_as_many_messages_as_its_size_says) {
  EXPECT_EQ(fill_up(*memory_of(16 * mb), mb).size(), 16u);
  EXPECT_EQ(fill_up(*memory_of(mb), 4096).size(), 256u);
  EXPECT_EQ(fill_up(*memory_of(page_size()), page_size()).size(), 1u);
}

TEST(Memory, a_released_block_is_reused_while_it_is_hot) {
  const auto memory = memory_of(64 * mb);
  const std::uint8_t* first = memory->allocate(4 * mb)->data();
  for (int i = 0; i < 10; ++i) EXPECT_EQ(memory->allocate(4 * mb)->data(), first);
  EXPECT_LT(memory->stats().reserved_bytes, 5 * mb);
}

TEST(Memory, a_sealed_block_is_reclaimed_too) {
  const auto memory = memory_of(2 * mb);
  memory->allocate(mb)->seal();
  for (int i = 0; i < 10; ++i) {
    const BufferPtr buffer = memory->allocate(mb);
    ASSERT_TRUE(buffer);
    EXPECT_FALSE(buffer->sealed());
    buffer->seal();
  }
}

TEST(Memory, is_sparse) {
  const auto memory = memory_of(std::size_t{64} << 30);
  ASSERT_TRUE(memory->allocate(100));
  EXPECT_LE(memory->stats().reserved_bytes, 2 * page_size());
  EXPECT_GE(memory->stats().size_bytes, std::size_t{64} << 30);
}

using Cause = AllocationError::Cause;

bool mentions(const Error& error, const std::string& words) {
  return error.text().find(words) != std::string::npos;
}

TEST(Memory, exhausted_is_null_with_a_reason) {
  const auto memory = memory_of(mb);
  EXPECT_EQ(memory->last_failure().cause, Cause::none);
  const BufferPtr all = memory->allocate(mb);
  EXPECT_FALSE(memory->allocate(mb));
  EXPECT_EQ(memory->stats().refused, 1u);
  EXPECT_EQ(memory->last_failure().cause, Cause::in_use);
  EXPECT_TRUE(mentions(memory->last_failure(), "older messages")) << memory->last_failure().text();
}

TEST(Memory, what_can_never_fit_is_no_matter_of_use) {
  const auto memory = memory_of(mb);
  for (const std::size_t bytes : {mb + page_size(), 2 * mb, SIZE_MAX / 4, SIZE_MAX}) {
    EXPECT_FALSE(memory->allocate(bytes));
    EXPECT_EQ(memory->last_failure().cause, Cause::too_large) << bytes;
    EXPECT_TRUE(mentions(memory->last_failure(), "has room for 1048576 bytes"))
        << memory->last_failure().text();
  }
}

TEST(Memory, size_zero_is_too_small_for_what_exceeds_its_ceiling) {
  MemoryOptions options;
  options.ceiling = 4 * mb;
  const auto memory = *SegmentMemory::create(options);
  std::vector<BufferPtr> held{memory->allocate(mb), memory->allocate(2 * mb)};
  ASSERT_TRUE(held.back());
  EXPECT_FALSE(memory->allocate(3 * mb));
  EXPECT_EQ(memory->last_failure().cause, Cause::in_use) << "it could have fitted";
  EXPECT_FALSE(memory->allocate(5 * mb));
  EXPECT_EQ(memory->last_failure().cause, Cause::too_large);
}

TEST(Memory, size_zero_sizes_itself_and_grows) {
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

TEST(Memory, size_zero_follows_messages_that_grow) {
  MemoryOptions options;
  options.ceiling = 64 * mb;
  const auto memory = *SegmentMemory::create(options);
  for (const std::size_t bytes : {std::size_t{1000}, mb, 4 * mb, 12 * mb})
    EXPECT_TRUE(memory->allocate(bytes)) << bytes;
  EXPECT_EQ(memory->stats().segments, 1u) << "segments that became too small are let go";
}

TEST(Memory, a_buffer_outlives_its_memory) {
  auto memory = memory_of(mb);
  const BufferPtr buffer = memory->allocate(1000);
  memory.reset();
  std::memset(buffer->data(), 5, buffer->size());
  EXPECT_TRUE(in_segment(buffer->data()));
}

TEST(Memory, finds_the_buffer_of_an_address) {
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

TEST(Memory, does_not_find_what_nobody_holds) {
  const auto memory = memory_of(mb);
  const std::uint8_t* address = memory->allocate(1000)->data();
  EXPECT_FALSE(find_buffer(address, 1));
}

TEST(Memory, prefault_all_reserves_everything) {
  MemoryOptions options;
  options.size = 4 * mb;
  options.prefault = Prefault::all;
  const auto memory = *SegmentMemory::create(options);
  EXPECT_GE(memory->stats().reserved_bytes, 4 * mb);
}

TEST(Memory, a_forked_child_can_read_but_not_allocate) {
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

TEST(Memory, a_forked_childs_writes_stay_its_own) {
  const auto memory = memory_of(mb);
  const BufferPtr buffer = memory->allocate(100'000);
  std::memset(buffer->data(), 7, buffer->size());
  const pid_t child = ::fork();
  if (child == 0) {
    const bool sees = buffer->data()[0] == 7 && buffer->data()[99'999] == 7;
    std::memset(buffer->data(), 8, buffer->size());
    ::_exit(sees && buffer->data()[99'999] == 8 ? 0 : 1);
  }
  int status = -1;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  EXPECT_EQ(status, 0);
  EXPECT_EQ(buffer->data()[0], 7);
  EXPECT_EQ(buffer->data()[99'999], 7);
}

// As a daemon forks twice.
TEST(Memory, a_forked_childs_writes_are_still_there_in_its_own_child) {
  const auto memory = memory_of(mb);
  const BufferPtr buffer = memory->allocate(100'000);
  std::memset(buffer->data(), 7, buffer->size());
  const auto status_of = [](pid_t child) {
    int status = -1;
    ::waitpid(child, &status, 0);
    return status;
  };
  const pid_t child = ::fork();
  if (child == 0) {
    std::memset(buffer->data(), 8, buffer->size());
    const pid_t grandchild = ::fork();
    if (grandchild == 0) ::_exit(buffer->data()[0] == 8 && buffer->data()[99'999] == 8 ? 0 : 1);
    ::_exit(status_of(grandchild) == 0 ? 0 : 1);
  }
  EXPECT_EQ(status_of(child), 0);
}

TEST(Memory, a_limit_on_file_sizes_is_an_error_and_no_death) {
  const pid_t child = ::fork();
  if (child == 0) {
    const rlimit limit{mb, mb};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    MemoryOptions options;
    options.size = 4 * mb;
    const auto refused = SegmentMemory::create(options);
    const bool says = !refused && refused.error().text().find("ulimit -f") != std::string::npos;
    options.size = mb / 2;
    const auto fits = SegmentMemory::create(options);
    ::_exit(says && fits && (*fits)->allocate(1000) ? 0 : 1);
  }
  int status = -1;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  EXPECT_EQ(status, 0) << "status " << status;
}

// The parent's thread is in the middle of allocate when it forks, so the child's copy of the lock is taken.
TEST(Memory, a_forked_child_may_ask_for_statistics) {
  static SegmentMemory* asked = nullptr;
  static pid_t child = -1;
  const auto memory = memory_of(mb);
  const BufferPtr buffer = memory->allocate(1000);
  asked = memory.get();
  sync_point_hook = [](const char*) {
    sync_point_hook = nullptr;
    child = ::fork();
    if (child != 0) return;
    ::alarm(10);
    ::_exit(asked->stats().allocated == 0 && asked->last_failure().text().empty() ? 0 : 1);
  };
  EXPECT_TRUE(memory->allocate(1000));
  int status = -1;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  EXPECT_EQ(status, 0) << "status " << status;
  EXPECT_EQ(memory->stats().allocated, 2u);
}

/// No limit again, whatever a test ends with.
struct Ceiling {
  explicit Ceiling(std::size_t bytes) { set_memory_ceiling(bytes); }
  ~Ceiling() { set_memory_ceiling(SIZE_MAX); }
};

TEST(MemoryCeiling, limits_all_memories_of_the_process_together) {
  const std::size_t before = process_memory().reserved_bytes;
  {
    const auto first = memory_of(8 * mb), second = memory_of(8 * mb);
    const Ceiling ceiling(process_memory().reserved_bytes + 5 * mb);
    BufferPtr small = first->allocate(2 * mb);
    const BufferPtr other = second->allocate(2 * mb);
    ASSERT_TRUE(small && other);
    EXPECT_FALSE(second->allocate(2 * mb));
    EXPECT_EQ(second->last_failure().cause, Cause::system);
    EXPECT_TRUE(mentions(second->last_failure(), "~tzc/memory_ceiling")) << second->last_failure().text();
    EXPECT_TRUE(first->allocate(1000)) << "what still fits is given";
    small.reset();
    EXPECT_TRUE(first->allocate(2 * mb)) << "memory that was taken before can be used again";
    EXPECT_LE(process_memory().reserved_bytes, process_memory().ceiling);
  }
  EXPECT_EQ(process_memory().reserved_bytes, before) << "memories that are gone count no more";
}

TEST(MemoryCeiling, refuses_a_memory_that_would_begin_above_it) {
  const Ceiling ceiling(process_memory().reserved_bytes);
  MemoryOptions options;
  options.size = mb;
  const auto refused = SegmentMemory::create(options);
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().text().find("memory_ceiling"), std::string::npos) << refused.error().text();
}

// As a subscriber that keeps its messages makes room by letting go of one.
TEST(MemoryCeiling, a_memory_that_grows_stays_below_it_and_goes_on) {
  const auto memory = *SegmentMemory::create();
  const Ceiling ceiling(process_memory().reserved_bytes + 20 * mb);
  std::vector<BufferPtr> held;
  while (BufferPtr buffer = memory->allocate(mb)) held.push_back(buffer);
  EXPECT_GE(held.size(), 15u);
  EXPECT_LE(process_memory().reserved_bytes, process_memory().ceiling);
  held.pop_back();
  EXPECT_TRUE(memory->allocate(mb));
}

TEST(Memory, threads_may_allocate_concurrently) {
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
