// SPDX-License-Identifier: BSD-3-Clause
#include "posix/mapping.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>

#include "posix/memory_file.h"

namespace tzc {
namespace posix {
namespace {

TEST(PageSize, is_the_systems_or_the_one_that_the_test_injects) {
  const char* injected = std::getenv("TZC_TEST_PAGE_SIZE");  // tests/support/other_page_size.cpp
  EXPECT_EQ(page_size(),
            injected ? std::strtoul(injected, nullptr, 10) : static_cast<std::size_t>(::getpagesize()));
}

TEST(Mapping, begins_with_a_page_and_may_end_within_one) {
  auto file = create_memory_file("tzc-test", 3 * page_size(), Sharing::peers_read);
  ASSERT_TRUE(file);
  auto mapping = Mapping::map(file->descriptor.get(), 2 * page_size() + 1, Access::read_write);
  ASSERT_TRUE(mapping);
  EXPECT_EQ(reinterpret_cast<std::uintptr_t>(mapping->data()) % page_size(), 0u);
  mapping->populate(page_size() + 1, page_size());
  mapping->data()[2 * page_size()] = 1;
  EXPECT_EQ(mapping->data()[page_size()], 0);
}

}  // namespace
}  // namespace posix
}  // namespace tzc
