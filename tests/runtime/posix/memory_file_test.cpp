// SPDX-License-Identifier: BSD-3-Clause
#include "posix/memory_file.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <limits>
#include <vector>

#include "posix/mapping.h"

namespace {
off_t most_bytes_without_a_signal = std::numeric_limits<off_t>::max();
}

/// In place of the C library's, which a timer may interrupt each time that it takes long.
extern "C" int posix_fallocate(int file, off_t offset, off_t bytes) {
  if (bytes > most_bytes_without_a_signal) return EINTR;
  return ::fallocate(file, 0, offset, bytes) == 0 ? 0 : errno;
}

namespace tzc {
namespace posix {
namespace {

constexpr std::size_t size = 1 << 20;

MemoryFile create(Sharing sharing) {
  auto file = create_memory_file("test", size, sharing);
  EXPECT_TRUE(file) << file.error().text();
  return std::move(*file);
}

TEST(MemoryFile, what_the_creator_writes_the_peer_reads) {
  MemoryFile file = create(Sharing::peers_read);
  auto mine = Mapping::map(file.descriptor.get(), size, Access::read_write);
  ASSERT_TRUE(seal(file, Sharing::peers_read));
  ASSERT_TRUE(reserve(file, 4096, 8192));
  auto theirs = Mapping::map(file.shared_fd(), size, Access::read_only);
  ASSERT_TRUE(theirs);
  mine->data()[5000] = 42;
  EXPECT_EQ(theirs->data()[5000], 42);
}

TEST(MemoryFile, a_peer_cannot_map_data_for_writing) {
  MemoryFile file = create(Sharing::peers_read);
  auto mine = Mapping::map(file.descriptor.get(), size, Access::read_write);
  ASSERT_TRUE(seal(file, Sharing::peers_read));
  EXPECT_FALSE(Mapping::map(file.shared_fd(), size, Access::read_write));
  auto theirs = Mapping::map(file.shared_fd(), size, Access::read_only);
  EXPECT_NE(::mprotect(theirs->data(), size, PROT_READ | PROT_WRITE), 0);
  EXPECT_EQ(::write(file.shared_fd(), "x", 1), -1);
}

TEST(MemoryFile, a_peer_cannot_change_its_size) {
  MemoryFile file = create(Sharing::peers_read);
  auto mine = Mapping::map(file.descriptor.get(), size, Access::read_write);
  ASSERT_TRUE(seal(file, Sharing::peers_read));
  EXPECT_NE(::ftruncate(file.shared_fd(), 0), 0);
  EXPECT_NE(::ftruncate(file.shared_fd(), 2 * size), 0);
}

TEST(MemoryFile, a_received_file_must_have_the_announced_size) {
  MemoryFile file = create(Sharing::peers_read);
  ASSERT_TRUE(seal(file, Sharing::peers_read));
  EXPECT_TRUE(check_received(file.shared_fd(), size, Sharing::peers_read));
  EXPECT_FALSE(check_received(file.shared_fd(), 2 * size, Sharing::peers_read));
}

// Or a mapping that fails would not tell whether the peer or this process is to blame.
TEST(MemoryFile, a_received_file_must_be_open_for_what_it_is_sent_for) {
  MemoryFile file = create(Sharing::peers_write);
  ASSERT_TRUE(seal(file, Sharing::peers_write));
  const std::string path = "/proc/self/fd/" + std::to_string(file.shared_fd());
  const FileDescriptor reads(::open(path.c_str(), O_RDONLY)), writes(::open(path.c_str(), O_WRONLY));
  EXPECT_TRUE(check_received(file.shared_fd(), size, Sharing::peers_write));
  EXPECT_TRUE(check_received(reads.get(), size, Sharing::peers_read));
  EXPECT_FALSE(check_received(reads.get(), size, Sharing::peers_write));
  EXPECT_FALSE(check_received(writes.get(), size, Sharing::peers_read));
}

#ifndef TZC_PORTABLE
TEST(MemoryFile, one_that_is_sealed_against_writing_is_refused_where_it_is_to_be_written) {
  MemoryFile file = create(Sharing::peers_write);
  ASSERT_EQ(::fcntl(file.shared_fd(), F_ADD_SEALS, F_SEAL_WRITE | F_SEAL_SHRINK | F_SEAL_GROW), 0);
  EXPECT_TRUE(check_received(file.shared_fd(), size, Sharing::peers_read));
  EXPECT_FALSE(check_received(file.shared_fd(), size, Sharing::peers_write));
}

TEST(MemoryFile, a_received_file_that_can_shrink_is_refused) {
  MemoryFile file = create(Sharing::peers_read);
  EXPECT_FALSE(check_received(file.shared_fd(), size, Sharing::peers_read));
  const FileDescriptor plain(::open("/proc/self/exe", O_RDONLY));
  EXPECT_FALSE(check_received(plain.get(), size, Sharing::peers_read));
}
#endif

#ifndef TZC_PORTABLE
// A huge page that is not there when it is touched is a SIGBUS, whatever is sealed.
TEST(MemoryFile, a_received_file_of_huge_pages_is_refused) {
  constexpr std::size_t huge = 2 << 20;
  const FileDescriptor file(::memfd_create("huge", MFD_CLOEXEC | MFD_ALLOW_SEALING | MFD_HUGETLB));
  ASSERT_TRUE(file) << "this kernel has no huge pages: nothing to refuse";
  ASSERT_EQ(::ftruncate(file.get(), huge), 0);
  ASSERT_EQ(::fcntl(file.get(), F_ADD_SEALS, F_SEAL_SHRINK | F_SEAL_GROW | F_SEAL_SEAL), 0);
  const Status checked = check_received(file.get(), huge, Sharing::peers_read);
  ASSERT_FALSE(checked);
  EXPECT_NE(checked.error().text().find("huge pages"), std::string::npos) << checked.error().text();
}

// Or vm.memfd_noexec = 2 would refuse it.
TEST(MemoryFile, cannot_be_executed) {
  const MemoryFile file = create(Sharing::peers_read);
  struct stat status{};
  ASSERT_EQ(::fstat(file.shared_fd(), &status), 0);
  EXPECT_EQ(status.st_mode & 0111, 0u);
}
#endif

// A signal every millisecond, while it takes longer than that to reserve everything.
TEST(MemoryFile, a_reserve_is_not_kept_from_its_end_by_signals) {
  const pid_t child = ::fork();
  if (child == 0) {
    constexpr std::size_t large = 256 << 20;
    struct sigaction action{};
    action.sa_handler = [](int) {};
    ::sigaction(SIGALRM, &action, nullptr);
    MemoryFile file = *create_memory_file("large", large, Sharing::peers_read);
    const itimerval often{{0, 1000}, {0, 1000}};
    ::setitimer(ITIMER_REAL, &often, nullptr);
    ::_exit(reserve(file, 0, large) ? 0 : 1);
  }
  int status = -1;
  for (int i = 0; i < 12'000 && ::waitpid(child, &status, WNOHANG) == 0; ++i) ::usleep(10'000);
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  EXPECT_EQ(status, 0);
}

// On a slow machine a timer's period may be too short for what a fast one does in it.
TEST(MemoryFile, a_reserve_that_is_interrupted_again_and_again_goes_on_in_smaller_steps) {
  const pid_t child = ::fork();
  if (child == 0) {
    ::alarm(60);
    most_bytes_without_a_signal = 64 << 10;
    constexpr std::size_t large = (9 << 20) + 4096;
    MemoryFile file = *create_memory_file("slow", large, Sharing::peers_read);
    struct stat status{};
    const bool reserved = static_cast<bool>(reserve(file, 0, large));
    ::fstat(file.descriptor.get(), &status);
    ::_exit(reserved && static_cast<std::size_t>(status.st_blocks) == large / 512 ? 0 : 1);
  }
  int status = -1;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  EXPECT_EQ(status, 0) << "status " << status;
}

// A publisher that finds no memory serializes its messages; a program that finds no descriptor for its socket is stuck.
TEST(MemoryFile, an_eighth_of_the_descriptors_is_left_to_the_program_in_a_child) {
  const pid_t child = ::fork();
  if (child == 0) {
    const rlimit limit{200, 200};
    ::setrlimit(RLIMIT_NOFILE, &limit);
    std::vector<MemoryFile> files;
    auto file = create_memory_file("one of many", size, Sharing::peers_read);
    for (; file; file = create_memory_file("one of many", size, Sharing::peers_read))
      files.push_back(std::move(*file));
    int left = 0;
    while (::open("/dev/null", O_RDONLY) >= 0) ++left;
    ::_exit(file.error().code == EMFILE && !files.empty() && left >= 25 && left <= 26 ? 0 : 1);
  }
  int status = -1;
  ::waitpid(child, &status, 0);
  EXPECT_EQ(status, 0);
}

TEST(MemoryFile, populate_keeps_contents) {
  MemoryFile file = create(Sharing::peers_read);
  auto mine = Mapping::map(file.descriptor.get(), size, Access::read_write);
  ASSERT_TRUE(reserve(file, 0, size));
  mine->data()[4096] = 7;
  mine->populate(100, size - 200);
  EXPECT_EQ(mine->data()[4096], 7);
}

TEST(MemoryFile, a_reserve_that_fails_says_why) {
  MemoryFile file = create(Sharing::peers_read);
  ASSERT_TRUE(seal(file, Sharing::peers_read));
  const Status beyond = reserve(file, 0, std::size_t{1} << 60);
  ASSERT_FALSE(beyond);
  EXPECT_NE(beyond.error().text().find("reserve"), std::string::npos);
}

// Step by step, all that the machine has would be gone before the refusal, and some process with it.
TEST(MemoryFile, a_reserve_beyond_the_machines_memory_takes_nothing) {
  constexpr std::size_t too_much = std::size_t{1} << 50;
  auto file = create_memory_file("too large", too_much, Sharing::peers_read);
  ASSERT_TRUE(file) << file.error().text();
  const Status refused = reserve(*file, 0, too_much);
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().text().find("less memory"), std::string::npos) << refused.error().text();
  struct stat status{};
  ASSERT_EQ(::fstat(file->descriptor.get(), &status), 0);
  EXPECT_EQ(status.st_blocks, 0);
}

TEST(MemoryFile, is_told_from_others_by_each_of_its_descriptors) {
  const auto one = create_memory_file("one", page_size(), Sharing::peers_write);
  const auto other = create_memory_file("other", page_size(), Sharing::peers_write);
  const FileDescriptor again(::dup(one->descriptor.get()));
  const FileIdentity first = *identify(one->descriptor.get()), second = *identify(again.get());
  const FileIdentity third = *identify(other->descriptor.get());
  EXPECT_FALSE(first < second || second < first);
  EXPECT_TRUE(first < third || third < first);
  EXPECT_FALSE(identify(-1));
}

}  // namespace
}  // namespace posix
}  // namespace tzc
