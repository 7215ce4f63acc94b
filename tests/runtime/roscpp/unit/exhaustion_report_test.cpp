// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/publish/exhaustion_report.h"

#include <gtest/gtest.h>
#include <tzc/process_memory.h>

#include <cstdint>
#include <memory>
#include <string>

#include "support/text.h"

namespace tzc {
namespace detail {
namespace {

using test::has;

MemoryOptions options_of(std::size_t size) {
  MemoryOptions options;
  options.size = size;
  options.queue_size = 10;
  return options;
}

constexpr std::size_t kMegabyte = std::size_t{1} << 20;

/// The report on a message of that size for which a real memory has no room.
std::string report_on(std::size_t message_bytes, const MemoryOptions& options, std::size_t already_used = 0) {
  const std::shared_ptr<SegmentMemory> memory = *SegmentMemory::create(options);
  const BufferPtr used = already_used > 0 ? memory->allocate(already_used) : nullptr;
  EXPECT_FALSE(memory->allocate(message_bytes));
  const Exhaustion what{"/image", message_bytes, OnExhausted::deliver, 12, "/viewer 3"};
  return exhaustion_report(what, memory->options(), memory->stats(), memory->last_failure());
}

TEST(ExhaustionReport, of_a_full_memory_says_what_why_who_and_what_to_do) {
  const std::string text = report_on(230400, options_of(400000), 300000);
  for (const char* part : {"/image", "message of 230400 bytes", "still use the older messages",
                           "sent serialized", "12 so far", "bytes are in use, by 1 blocks", "/viewer 3",
                           "~tzc/memory_size to 4M", "now 400000", "see which subscriber"})
    EXPECT_TRUE(has(text, part)) << part << " in: " << text;
}

TEST(ExhaustionReport, tells_the_memory_s_figures) {
  MemoryStats memory;
  memory.size_bytes = 1000;
  memory.used_bytes = 640;
  memory.used_blocks = 2;
  AllocationError failure;
  failure.cause = AllocationError::Cause::in_use;
  const Exhaustion what{"/image", 500, OnExhausted::deliver, 12, "/viewer 3"};
  const std::string text = exhaustion_report(what, options_of(1000), memory, failure);
  EXPECT_TRUE(has(text, "640 of 1000 bytes are in use, by 2 blocks")) << text;
}

TEST(ExhaustionReport, a_message_that_will_never_fit_is_nobodys_fault) {
  const std::string text = report_on(230400, options_of(1000));
  for (const char* part :
       {"larger than the whole memory", "room for 4096 bytes", "~tzc/memory_size to 4M", "now 1000"})
    EXPECT_TRUE(has(text, part)) << part << " in: " << text;
  for (const char* part : {"older messages", "in use", "subscriber"})
    EXPECT_FALSE(has(text, part)) << part << " in: " << text;
}

TEST(ExhaustionReport, nor_is_one_whose_arrays_fit_one_by_one_alone) {
  const std::shared_ptr<SegmentMemory> memory = *SegmentMemory::create(options_of(150000));
  const BufferPtr first = memory->allocate(100000);
  EXPECT_FALSE(memory->allocate(100000));
  const Exhaustion what{"/cloud", 200000, OnExhausted::deliver, 1, ""};
  const std::string text =
      exhaustion_report(what, memory->options(), memory->stats(), memory->last_failure());
  EXPECT_TRUE(has(text, "larger than the whole memory")) << text;
  EXPECT_FALSE(has(text, "older messages")) << text;
}

TEST(ExhaustionReport, a_ceiling_is_named_and_no_size_is_advised) {
  set_memory_ceiling(process_memory().reserved_bytes + 500000);
  const std::string text = report_on(1000000, options_of(0));
  set_memory_ceiling(SIZE_MAX);
  EXPECT_TRUE(has(text, "~tzc/memory_ceiling")) << text;
  EXPECT_TRUE(has(text, "TZC_MEMORY_CEILING")) << text;
  for (const char* part : {"memory_size", "by 0 blocks"})
    EXPECT_FALSE(has(text, part)) << part << " in: " << text;
}

TEST(ExhaustionReport, what_the_system_gave_is_advised_where_that_is_enough_for_some_messages) {
  MemoryStats memory;
  memory.reserved_bytes = 64 * kMegabyte + 5;
  AllocationError failure;
  failure.cause = AllocationError::Cause::system;
  const Exhaustion what{"/image", 4'000'000, OnExhausted::deliver, 12, ""};
  const std::string text = exhaustion_report(what, options_of(0), memory, failure);
  EXPECT_TRUE(has(text, "~tzc/memory_size at 64M")) << text;
  memory.reserved_bytes = 2 * what.message_bytes;
  EXPECT_FALSE(has(exhaustion_report(what, options_of(0), memory, failure), "memory_size"));
  memory.reserved_bytes = 64 * kMegabyte;
  EXPECT_FALSE(has(exhaustion_report(what, options_of(64 * kMegabyte), memory, failure), "memory_size at"));
}

TEST(ExhaustionReport, a_size_that_should_be_enough_is_not_advised_again) {
  const std::string text = report_on(kMegabyte, options_of(20 * kMegabyte), 20 * kMegabyte);
  EXPECT_FALSE(has(text, "Set ~tzc/memory_size to")) << text;
  for (const char* part : {"see which subscriber keeps its messages", "raise ~tzc/memory_size"})
    EXPECT_TRUE(has(text, part)) << part << " in: " << text;
}

TEST(ExhaustionReport, a_dropped_message_is_called_dropped) {
  const Exhaustion what{"/image", 100, OnExhausted::drop, 1, ""};
  const std::string text = exhaustion_report(what, options_of(1000), MemoryStats(), AllocationError());
  EXPECT_TRUE(has(text, "dropped, as ~tzc/on_exhausted says")) << text;
  EXPECT_FALSE(has(text, "not taken yet")) << text;
}

}  // namespace
}  // namespace detail
}  // namespace tzc
