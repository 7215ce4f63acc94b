// SPDX-License-Identifier: BSD-3-Clause
#include "posix/memory_file.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <unistd.h>

#include "posix/mapping.h"

namespace tzc {
namespace posix {
namespace {

constexpr std::size_t size = 1 << 20;

MemoryFile create(Sharing sharing) {
  auto file = create_memory_file("test", size, sharing);
  EXPECT_TRUE(file) << file.error().text();
  return std::move(*file);
}

TEST(MemoryFile, WhatTheCreatorWritesThePeerReads) {
  MemoryFile file = create(Sharing::peers_read);
  auto mine = Mapping::map(file.descriptor.get(), size, Access::read_write);
  ASSERT_TRUE(seal(file, Sharing::peers_read));
  ASSERT_TRUE(reserve(file, 4096, 8192));
  auto theirs = Mapping::map(file.shared_fd(), size, Access::read_only);
  ASSERT_TRUE(theirs);
  mine->data()[5000] = 42;
  EXPECT_EQ(theirs->data()[5000], 42);
}

TEST(MemoryFile, APeerCanNotMapDataForWriting) {
  MemoryFile file = create(Sharing::peers_read);
  auto mine = Mapping::map(file.descriptor.get(), size, Access::read_write);
  ASSERT_TRUE(seal(file, Sharing::peers_read));
  EXPECT_FALSE(Mapping::map(file.shared_fd(), size, Access::read_write));
  auto theirs = Mapping::map(file.shared_fd(), size, Access::read_only);
  EXPECT_NE(::mprotect(theirs->data(), size, PROT_READ | PROT_WRITE), 0);
  EXPECT_EQ(::write(file.shared_fd(), "x", 1), -1);
}

TEST(MemoryFile, APeerCanNotChangeItsSize) {
  MemoryFile file = create(Sharing::peers_read);
  auto mine = Mapping::map(file.descriptor.get(), size, Access::read_write);
  ASSERT_TRUE(seal(file, Sharing::peers_read));
  EXPECT_NE(::ftruncate(file.shared_fd(), 0), 0);
  EXPECT_NE(::ftruncate(file.shared_fd(), 2 * size), 0);
}

TEST(MemoryFile, AReceivedFileMustHaveTheAnnouncedSize) {
  MemoryFile file = create(Sharing::peers_read);
  ASSERT_TRUE(seal(file, Sharing::peers_read));
  EXPECT_TRUE(check_received(file.shared_fd(), size, Sharing::peers_read));
  EXPECT_FALSE(check_received(file.shared_fd(), 2 * size, Sharing::peers_read));
}

#ifndef TZC_PORTABLE
TEST(MemoryFile, AReceivedFileThatCanShrinkIsRefused) {
  MemoryFile file = create(Sharing::peers_read);
  EXPECT_FALSE(check_received(file.shared_fd(), size, Sharing::peers_read));
  const FileDescriptor plain(::open("/proc/self/exe", O_RDONLY));
  EXPECT_FALSE(check_received(plain.get(), size, Sharing::peers_read));
}
#endif

TEST(MemoryFile, PopulateKeepsContents) {
  MemoryFile file = create(Sharing::peers_read);
  auto mine = Mapping::map(file.descriptor.get(), size, Access::read_write);
  ASSERT_TRUE(reserve(file, 0, size));
  mine->data()[4096] = 7;
  mine->populate(100, size - 200);
  EXPECT_EQ(mine->data()[4096], 7);
}

TEST(MemoryFile, AReserveThatFailsSaysWhy) {
  MemoryFile file = create(Sharing::peers_read);
  ASSERT_TRUE(seal(file, Sharing::peers_read));
  const Status beyond = reserve(file, 0, std::size_t{1} << 60);
  ASSERT_FALSE(beyond);
  EXPECT_NE(beyond.error().text().find("reserve"), std::string::npos);
}

}  // namespace
}  // namespace posix
}  // namespace tzc
