// SPDX-License-Identifier: BSD-3-Clause
#include "posix/nonce.h"

#include <cstdint>
#include <cstdio>
#include <random>

namespace tzc {
namespace posix {

// libstdc++'s random_device reads the kernel's generator (rdrand, getentropy or /dev/urandom).
std::string nonce() {
  std::random_device random;
  char text[33];
  std::snprintf(text, sizeof text, "%08x%08x%08x%08x", random(), random(), random(), random());
  return text;
}

}  // namespace posix
}  // namespace tzc
