// SPDX-License-Identifier: BSD-3-Clause
#include "posix/memory_file.h"

#include <fcntl.h>
#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <string>

#include "posix/descriptor_use.h"
#include "posix/error.h"
#include "posix/mapping.h"
#include "posix/memory_limit.h"
#include "posix/size_signal.h"

namespace tzc {
namespace posix {

namespace {

constexpr std::size_t left_for_the_process = std::size_t{4} << 20;  // it has to go on after the refusal

constexpr std::size_t largest_step = std::size_t{4} << 20;

// A page is reserved sooner than any timer interrupts it again.
std::size_t smaller_step(std::size_t bytes) {
  const std::size_t page = page_size();
  return std::max(bytes / 2 / page * page, page);
}

Error over_the_limit(std::size_t bytes, std::size_t headroom) {
  Error error;
  error.what = "reserve " + std::to_string(bytes) + " bytes of shared memory";
  error.hint = "the memory limit of the machine or of the process's control group leaves " +
               std::to_string(headroom) +
               " bytes: give the publisher less memory, or raise the container's limit";
  error.code = ENOMEM;
  return error;
}

Error over_the_ceiling(std::size_t bytes) {
  Error error;
  error.what = "reserve " + std::to_string(bytes) + " bytes of shared memory";
  error.hint = "this process has " + std::to_string(reserved_memory()) + " bytes and may have " +
               std::to_string(memory_ceiling()) +
               " in all: raise that (in a node ~tzc/memory_ceiling or TZC_MEMORY_CEILING, else "
               "tzc::set_memory_ceiling), or give its publishers less memory";
  error.code = ENOMEM;
  return error;
}

Status check_headroom(std::size_t bytes) {
  static HeadroomAllowance allowance;
  const auto now = HeadroomAllowance::Clock::now();
  if (allowance.take(bytes, now)) return Success{};
  const std::size_t headroom = memory_headroom();
  if (headroom < left_for_the_process || headroom - left_for_the_process < bytes)
    return over_the_limit(bytes, headroom);
  allowance.refill(headroom - left_for_the_process, bytes, now);
  return Success{};
}

// An interrupted call gives back what it had reserved: a process with a timer would never come to the end of a large one, nor,
// on a slow machine, of one that takes longer than the timer's period.
Status reserve_in_steps(const MemoryFile& file, std::size_t offset, std::size_t bytes) {
  const SizeSignalBlocked blocked;
  std::size_t step = largest_step;
  for (std::size_t done = 0; done < bytes;) {
    const std::size_t part = std::min(step, bytes - done);
    const int failure =  // posix_fallocate returns it
        ::posix_fallocate(file.descriptor.get(), static_cast<off_t>(offset + done), static_cast<off_t>(part));
    if (failure == 0) done += part;
    if (failure == EINTR) step = smaller_step(part);
    if (failure == 0 || failure == EINTR) continue;
    errno = failure;
    return system_error("reserve " + std::to_string(bytes) + " bytes of shared memory");
  }
  return Success{};
}

}  // namespace

FileDescriptor within_share(FileDescriptor descriptor) noexcept {
  if (!descriptor || leaves_enough(descriptor.get())) return descriptor;
  descriptor.reset();
  errno = EMFILE;
  return descriptor;
}

Status reserve(MemoryFile& file, std::size_t offset, std::size_t bytes) {
  return reserve(file, file.reserved, offset, bytes);
}

Status reserve(const MemoryFile& file, ReservedBytes& reserved, std::size_t offset, std::size_t bytes) {
  const Status there = check_headroom(bytes);
  if (!there) return there;
  if (!reserved.add(bytes)) return over_the_ceiling(bytes);
  const Status done = reserve_in_steps(file, offset, bytes);
  if (!done) reserved.remove(bytes);
  return done;
}

Expected<FileIdentity> identify(int fd) {
  struct stat status{};
  if (::fstat(fd, &status) != 0) return system_error("inspect a memory file");
  return FileIdentity{status.st_dev, status.st_ino};
}

}  // namespace posix
}  // namespace tzc
