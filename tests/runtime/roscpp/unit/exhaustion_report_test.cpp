// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/publish/exhaustion_report.h"

#include <gtest/gtest.h>

namespace tzc {
namespace detail {
namespace {

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

MemoryOptions small_memory() {
  MemoryOptions options;
  options.size = 1000;
  options.queue_size = 10;
  return options;
}

TEST(ExhaustionReport, says_what_why_who_and_what_to_do) {
  MemoryStats memory;
  memory.size_bytes = 1000;
  memory.used_bytes = 640;
  memory.used_blocks = 2;
  const Exhaustion what{"/image", 230400, OnExhausted::deliver, 12, "/viewer 3"};
  const std::string text = exhaustion_report(what, small_memory(), memory, "larger than the memory");
  for (const char* part :
       {"/image", "230400 bytes", "larger than the memory", "sent serialized", "12 so far",
        "640 of 1000 bytes", "2 blocks", "/viewer 3", "~tzc/memory_size to 3M", "now 1000"})
    EXPECT_TRUE(has(text, part)) << part << " in: " << text;
}

TEST(ExhaustionReport, a_dropped_message_is_called_dropped) {
  const Exhaustion what{"/image", 100, OnExhausted::drop, 1, ""};
  const std::string text = exhaustion_report(what, small_memory(), MemoryStats(), "");
  EXPECT_TRUE(has(text, "dropped, as ~tzc/on_exhausted says")) << text;
  EXPECT_FALSE(has(text, "not taken yet")) << text;
}

}  // namespace
}  // namespace detail
}  // namespace tzc
