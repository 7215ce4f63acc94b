// SPDX-License-Identifier: BSD-3-Clause
#include "posix/shared_memory.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

namespace tzc {
namespace posix {
namespace {

std::size_t committed_bytes(const SharedMemory& memory) {
  struct stat status = {};
  EXPECT_EQ(::fstat(memory.file.shared_fd(), &status), 0);
  return static_cast<std::size_t>(status.st_blocks) * 512;
}

TEST(SharedMemory, what_is_written_here_is_read_by_who_receives_the_file) {
  const std::size_t size = 2 * page_size();
  const auto memory = create_shared_memory("tzc-test", size, size, Sharing::peers_read);
  ASSERT_TRUE(memory);
  memory->mapping.data()[size - 1] = 42;
  ASSERT_TRUE(check_received(memory->file.shared_fd(), size, Sharing::peers_read));
  const auto received = Mapping::map(memory->file.shared_fd(), size, Access::read_only);
  ASSERT_TRUE(received);
  EXPECT_EQ(received->data()[size - 1], 42);
}

TEST(SharedMemory, only_what_was_asked_for_is_committed) {
  const std::size_t size = 16 * page_size();
  const auto none = create_shared_memory("tzc-test", size, 0, Sharing::peers_read);
  const auto some = create_shared_memory("tzc-test", size, page_size(), Sharing::peers_read);
  ASSERT_TRUE(none && some);
  EXPECT_EQ(committed_bytes(*none), 0u);
  EXPECT_EQ(committed_bytes(*some), page_size());
}

}  // namespace
}  // namespace posix
}  // namespace tzc
