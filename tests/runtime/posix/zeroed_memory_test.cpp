// SPDX-License-Identifier: BSD-3-Clause
#include "posix/zeroed_memory.h"

#include <gtest/gtest.h>
#include <sys/auxv.h>
#include <sys/mman.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <vector>

#include "posix/mapping.h"

namespace tzc {
namespace posix {
namespace {

/// The kernel counts in its own pages, whatever size of a page this process is told.
long pages_in_memory(const ZeroedMemory& memory, std::size_t bytes) {
  std::vector<unsigned char> resident(bytes / ::getauxval(AT_PAGESZ));
  EXPECT_EQ(::mincore(memory.data(), bytes, resident.data()), 0);
  return std::count_if(resident.begin(), resident.end(), [](unsigned char one) { return (one & 1) != 0; });
}

TEST(ZeroedMemory, is_zero_and_writable_at_any_size) {
  for (const std::size_t bytes :
       {std::size_t{1}, std::size_t{256}, page_size() - 1, page_size(), 10 * page_size()}) {
    const auto memory = ZeroedMemory::create(bytes);
    ASSERT_TRUE(memory);
    EXPECT_TRUE(
        std::all_of(memory->data(), memory->data() + bytes, [](std::uint8_t byte) { return byte == 0; }));
    std::fill_n(memory->data(), bytes, std::uint8_t{1});
  }
}

TEST(ZeroedMemory, takes_pages_that_were_written_alone) {
  const std::size_t bytes = 256 * page_size();
  const auto memory = ZeroedMemory::create(bytes);
  ASSERT_TRUE(memory);
  EXPECT_EQ(pages_in_memory(*memory, bytes), 0);
  memory->data()[5 * page_size()] = 1;
  EXPECT_EQ(pages_in_memory(*memory, bytes), 1);
}

TEST(ZeroedMemory, that_the_system_does_not_have_is_an_error) {
  const auto memory = ZeroedMemory::create(SIZE_MAX / 2);
  ASSERT_FALSE(memory);
  EXPECT_EQ(memory.error().code, ENOMEM);
}

}  // namespace
}  // namespace posix
}  // namespace tzc
