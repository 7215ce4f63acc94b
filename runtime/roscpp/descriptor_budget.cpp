// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/descriptor_budget.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>

namespace tzc {
namespace detail {
namespace {

rlim_t most_descriptors() {
  rlimit limit = {};
  return getrlimit(RLIMIT_NOFILE, &limit) == 0 ? limit.rlim_cur : 0;
}

}  // namespace

bool has_spare_descriptors() {
  const int lowest_free = open("/dev/null", O_RDONLY | O_CLOEXEC);
  if (lowest_free < 0) return false;
  close(lowest_free);
  return static_cast<rlim_t>(lowest_free) < most_descriptors() / 8 * 7;
}

std::string descriptor_advice() {
  return "more than seven eighths of the " + std::to_string(most_descriptors()) +
         " file descriptors that this process may have are in use, and the others are left to roscpp; raise "
         "the limit (ulimit -n)";
}

}  // namespace detail
}  // namespace tzc
