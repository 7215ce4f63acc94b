// SPDX-License-Identifier: BSD-3-Clause
#include "posix/memory_file.h"

#include <fcntl.h>

#include <cerrno>
#include <string>

#include "posix/error.h"

namespace tzc {
namespace posix {

Status reserve(const MemoryFile& file, std::size_t offset, std::size_t bytes) {
  int failure = 0;
  do {
    failure = ::posix_fallocate(file.descriptor.get(), static_cast<off_t>(offset), static_cast<off_t>(bytes));
  } while (failure == EINTR);
  if (failure == 0) return Success{};
  errno = failure;  // posix_fallocate returns it instead
  return system_error("reserve " + std::to_string(bytes) + " bytes of shared memory");
}

}  // namespace posix
}  // namespace tzc
