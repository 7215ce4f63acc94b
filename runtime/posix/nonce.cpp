// SPDX-License-Identifier: BSD-3-Clause
#include "posix/nonce.h"

#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstdio>

namespace tzc {
namespace posix {

namespace {

// From the kernel, without a descriptor: a process that has none left may still listen.
void fill(void* random, std::size_t size) {
  while (::getentropy(random, size) != 0) {
  }
}

}  // namespace

std::string nonce() {
  std::uint32_t random[4] = {};
  fill(random, sizeof random);
  char text[33];
  std::snprintf(text, sizeof text, "%08x%08x%08x%08x", random[0], random[1], random[2], random[3]);
  return text;
}

std::uint64_t random_number() {
  std::uint64_t random = 0;
  fill(&random, sizeof random);
  return random;
}

}  // namespace posix
}  // namespace tzc
