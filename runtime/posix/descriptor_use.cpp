// SPDX-License-Identifier: BSD-3-Clause
#include "posix/descriptor_use.h"

#include <fcntl.h>
#include <sys/resource.h>

#include <climits>

#include "posix/file_descriptor.h"

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

bool has_spare_descriptors() noexcept {
  const FileDescriptor lowest_free(::open("/dev/null", O_RDONLY | O_CLOEXEC));
  return lowest_free && leaves_enough(lowest_free.get());
}

std::string descriptors_in_use() {
  return "more than seven eighths of the " + std::to_string(descriptor_limit()) +
         " file descriptors that this process may have are in use";
}

}  // namespace posix
}  // namespace tzc
