// SPDX-License-Identifier: BSD-3-Clause
#include "posix/nonce.h"

#include <unistd.h>

#include <cstdint>
#include <cstdio>

namespace tzc {
namespace posix {

// From the kernel, without a descriptor: a process that has none left may still listen.
std::string nonce() {
  std::uint32_t random[4] = {};
  while (::getentropy(random, sizeof random) != 0) {
  }
  char text[33];
  std::snprintf(text, sizeof text, "%08x%08x%08x%08x", random[0], random[1], random[2], random[3]);
  return text;
}

}  // namespace posix
}  // namespace tzc
