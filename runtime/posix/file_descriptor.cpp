// SPDX-License-Identifier: BSD-3-Clause
#include "posix/file_descriptor.h"

#include <unistd.h>

#include <cerrno>

namespace tzc {
namespace posix {

FileDescriptor::~FileDescriptor() {
  if (fd_ < 0) return;
  const int saved = errno;  // destructors run on error paths, between the failure and its report
  ::close(fd_);
  errno = saved;
}

}  // namespace posix
}  // namespace tzc
