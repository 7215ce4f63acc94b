// SPDX-License-Identifier: BSD-3-Clause
#include "posix/descriptor_use.h"

#include <sys/resource.h>
#include <sys/socket.h>

#include <cerrno>
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
  const FileDescriptor lowest_free(::socket(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0));
  if (lowest_free) return leaves_enough(lowest_free.get());
  return errno != EMFILE && errno != ENFILE;
}

std::string descriptors_in_use() {
  return "more than seven eighths of the " + std::to_string(descriptor_limit()) +
         " file descriptors that this process may have are in use";
}

}  // namespace posix
}  // namespace tzc
