// SPDX-License-Identifier: BSD-3-Clause
#include "posix/memory_file.h"

#include <fcntl.h>

#include <cerrno>
#include <string>

#include "posix/error.h"
#include "posix/memory_limit.h"

namespace tzc {
namespace posix {

namespace {

constexpr std::size_t left_for_the_process = std::size_t{4} << 20;  // it has to go on after the refusal

Error over_the_limit(std::size_t bytes, std::size_t headroom) {
  Error error;
  error.what = "reserve " + std::to_string(bytes) + " bytes of shared memory";
  error.hint = "the memory limit of the process's control group leaves " + std::to_string(headroom) +
               " bytes: raise the container's limit, or give the publisher less memory";
  error.code = ENOMEM;
  return error;
}

}  // namespace

Status reserve(const MemoryFile& file, std::size_t offset, std::size_t bytes) {
  const std::size_t headroom = memory_headroom();
  if (headroom < left_for_the_process || headroom - left_for_the_process < bytes)
    return over_the_limit(bytes, headroom);
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
