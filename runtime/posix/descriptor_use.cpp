// SPDX-License-Identifier: BSD-3-Clause
#include "posix/descriptor_use.h"

#include <sys/resource.h>

#include <climits>

namespace tzc {
namespace posix {

std::size_t descriptor_limit() noexcept {
  rlimit limit{};
  return ::getrlimit(RLIMIT_NOFILE, &limit) == 0 ? static_cast<std::size_t>(limit.rlim_cur) : INT_MAX;
}

bool leaves_enough(int newest) noexcept {
  const std::size_t limit = descriptor_limit();
  return static_cast<std::size_t>(newest) < limit - limit / 8;
}

}  // namespace posix
}  // namespace tzc
