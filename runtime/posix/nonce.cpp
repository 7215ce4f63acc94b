// SPDX-License-Identifier: BSD-3-Clause
#include "posix/nonce.h"

#include <sys/auxv.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <ctime>

namespace tzc {
namespace posix {

namespace {

// Where a sandbox forbids to ask the kernel: what that gave the program when it started, mixed (splitmix64) with what differs from
// call to call and in a child.
void mix(std::uint32_t* random, std::size_t words) {
  static std::atomic<std::uint64_t> calls{0};
  std::uint64_t given[2] = {};
  if (const void* at_start = reinterpret_cast<const void*>(::getauxval(AT_RANDOM)))
    std::memcpy(given, at_start, sizeof given);
  std::timespec now{};
  ::clock_gettime(CLOCK_MONOTONIC, &now);
  std::uint64_t state = given[0] ^ (static_cast<std::uint64_t>(::getpid()) << 32) ^ ++calls ^
                        static_cast<std::uint64_t>(now.tv_nsec);
  for (std::size_t i = 0; i < words; ++i) {
    state += 0x9e3779b97f4a7c15 ^ (given[1] << 1);
    std::uint64_t mixed = (state ^ (state >> 30)) * 0xbf58476d1ce4e5b9;
    mixed = (mixed ^ (mixed >> 27)) * 0x94d049bb133111eb;
    random[i] = static_cast<std::uint32_t>(mixed ^ (mixed >> 31));
  }
}

// From the kernel, without a descriptor: a process that has none left may still listen.
void fill(std::uint32_t* random, std::size_t words) {
  while (::getentropy(random, words * sizeof *random) != 0)
    if (errno != EINTR) return mix(random, words);
}

}  // namespace

std::string nonce() {
  std::uint32_t random[4] = {};
  fill(random, 4);
  char text[33];
  std::snprintf(text, sizeof text, "%08x%08x%08x%08x", random[0], random[1], random[2], random[3]);
  return text;
}

std::uint64_t random_number() {
  std::uint32_t random[2] = {};
  fill(random, 2);
  return (static_cast<std::uint64_t>(random[0]) << 32) | random[1];
}

}  // namespace posix
}  // namespace tzc
