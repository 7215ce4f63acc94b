// SPDX-License-Identifier: BSD-3-Clause
#include "cost.h"

#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cstdlib>
#include <cstring>
#include <string>
#include <thread>
#include <vector>

namespace {

using namespace tzc::bench;

/// Counts this process for as long as it exists.
struct Counting {
  Counting() { count_into(&counts); }
  ~Counting() { count_into(nullptr); }
  Cost spent() const { return cost_of(::getpid(), counts); }

  Counts counts{};
};

// The compiler must not see how much is copied, or it copies by itself.
void* copy(void* (*how)(void*, const void*, std::size_t), void* to, const void* from,
           volatile std::size_t size) {
  return how(to, from, size);
}

TEST(Cost, has_the_bytes_that_the_program_copies) {
  std::vector<char> from(5000, 'x'), to(5000);
  const Counting counting;
  copy(&std::memcpy, to.data(), from.data(), 4000);
  copy(&std::memmove, to.data() + 1, to.data(), 3000);
  copy(&std::memcpy, to.data(), from.data(), least_copy_bytes - 1);
  EXPECT_EQ(counting.spent().copied_bytes, 7000u);
}

TEST(Cost, has_the_bytes_that_a_library_copies) {
  const std::string from(9000, 'x');
  std::string to;
  to.reserve(from.size());
  const Counting counting;
  to.append(from.c_str(), from.size());  // in libstdc++
  EXPECT_EQ(counting.spent().copied_bytes, 9000u);
}

TEST(CountedCall, does_what_it_does_without_being_counted) {
  std::vector<char> bytes(3000);
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<char>(i % 100);
  std::vector<char> expected(bytes.begin(), bytes.begin() + 2000);
  EXPECT_EQ(copy(&std::memmove, bytes.data() + 500, bytes.data(), 2000), bytes.data() + 500);
  EXPECT_EQ(std::vector<char>(bytes.begin() + 500, bytes.begin() + 2500), expected);
}

TEST(Cost, has_the_bytes_that_went_through_sockets_and_no_others) {
  int ends[2];
  ASSERT_EQ(::socketpair(AF_UNIX, SOCK_STREAM, 0, ends), 0);
  char bytes[100] = {};
  const Counting counting;
  EXPECT_EQ(::send(ends[0], bytes, 70, 0), 70);
  EXPECT_EQ(::recv(ends[1], bytes, 100, 0), 70);
  EXPECT_EQ(::recv(ends[1], bytes, 100, MSG_DONTWAIT), -1);
  const Cost spent = counting.spent();
  EXPECT_EQ(spent.sent_bytes, 70u);
  EXPECT_EQ(spent.received_bytes, 70u);
  ::close(ends[0]);
  ::close(ends[1]);
}

TEST(Cost, has_of_what_was_offered_what_the_socket_took) {
  int ends[2];
  ASSERT_EQ(::socketpair(AF_UNIX, SOCK_STREAM, 0, ends), 0);
  std::vector<char> bytes(1 << 20);
  iovec part{bytes.data(), bytes.size()};
  msghdr message{};
  message.msg_iov = &part;
  message.msg_iovlen = 1;
  const Counting counting;
  const ssize_t taken = ::sendmsg(ends[0], &message, MSG_DONTWAIT);
  ASSERT_GT(taken, 0);
  ASSERT_LT(taken, 1 << 20);
  EXPECT_EQ(::send(ends[0], bytes.data(), bytes.size(), MSG_DONTWAIT), -1);
  EXPECT_EQ(counting.spent().sent_bytes, static_cast<std::uint64_t>(taken));
  ::close(ends[0]);
  ::close(ends[1]);
}

TEST(Cost, has_whatever_was_received) {
  int ends[2];
  ASSERT_EQ(::socketpair(AF_UNIX, SOCK_SEQPACKET, 0, ends), 0);
  constexpr std::uint64_t packets = 20000;
  const Counting counting;
  std::thread sender([&] {
    const char byte = 0;
    for (std::uint64_t i = 0; i < packets; ++i) ::send(ends[0], &byte, 1, 0);
  });
  std::uint64_t missing = 0;
  char byte;
  for (std::uint64_t i = 1; i <= packets && ::recv(ends[1], &byte, 1, 0) == 1; ++i)
    if (counting.counts.sent < i) ++missing;
  sender.join();
  EXPECT_EQ(missing, 0u);
  EXPECT_EQ(counting.spent().sent_bytes, packets);
  ::close(ends[0]);
  ::close(ends[1]);
}

TEST(Cost, has_the_allocations_of_the_program_and_of_its_libraries) {
  std::string text;
  const Counting counting;
  void* const memory = std::malloc(100);
  void* const larger = std::realloc(memory, 200);
  text.reserve(1000);  // in libstdc++
  EXPECT_EQ(counting.counts.allocations, 3u);
  std::free(larger);
  EXPECT_EQ(counting.counts.allocations, 3u) << "free is none";
}

TEST(Cost, has_the_kernels_count_of_page_faults) {
  const auto page = static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
  constexpr std::size_t pages = 300;
  void* memory = ::mmap(nullptr, pages * page, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  ASSERT_NE(memory, MAP_FAILED);
  ::madvise(memory, pages * page, MADV_NOHUGEPAGE);
  const Counting counting;
  const Cost before = counting.spent();
  for (std::size_t i = 0; i < pages; ++i) static_cast<volatile char*>(memory)[i * page] = 1;
  const std::uint64_t faults = (counting.spent() - before).page_faults;
  EXPECT_GE(faults, pages);
  EXPECT_LT(faults, 2 * pages);
  ::munmap(memory, pages * page);
}

}  // namespace
