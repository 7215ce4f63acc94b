// SPDX-License-Identifier: BSD-3-Clause
// Linux: memfd with seals.
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include "posix/error.h"
#include "posix/memory_file.h"

#ifndef F_SEAL_FUTURE_WRITE
#define F_SEAL_FUTURE_WRITE 0x0010
#endif

namespace tzc {
namespace posix {
namespace {

constexpr int size_seals = F_SEAL_SHRINK | F_SEAL_GROW;

Error refused(const char* what) {
  Error error;
  error.what = std::string("refuse a received memory file: ") + what;
  error.hint = "the peer is not a TZC process of this version";
  return error;
}

// The kernel before 5.1 has no F_SEAL_FUTURE_WRITE; a read-only descriptor still keeps honest peers from
// writing.
Status seal_against_writers(int fd) {
  if (::fcntl(fd, F_ADD_SEALS, size_seals | F_SEAL_FUTURE_WRITE | F_SEAL_SEAL) == 0) return Success{};
  if (::fcntl(fd, F_ADD_SEALS, size_seals | F_SEAL_SEAL) == 0) return Success{};
  return system_error("seal a memory file");
}

}  // namespace

Expected<MemoryFile> create_memory_file(const char* name, std::size_t size, Sharing) {
  MemoryFile file;
  file.descriptor = FileDescriptor(::memfd_create(name, MFD_CLOEXEC | MFD_ALLOW_SEALING));
  if (!file.descriptor) return system_error("create a memory file", name);
  if (::ftruncate(file.descriptor.get(), static_cast<off_t>(size)) != 0)
    return system_error("size a memory file to " + std::to_string(size) + " bytes", name);
  file.size = size;
  return file;
}

Status seal(MemoryFile& file, Sharing sharing) {
  if (sharing == Sharing::peers_read) return seal_against_writers(file.descriptor.get());
  if (::fcntl(file.descriptor.get(), F_ADD_SEALS, size_seals | F_SEAL_SEAL) == 0) return Success{};
  return system_error("seal a memory file");
}

Status check_received(int fd, std::size_t size, Sharing) {
  const int seals = ::fcntl(fd, F_GET_SEALS);
  if (seals < 0) return refused("it is not a memfd");
  if ((seals & size_seals) != size_seals) return refused("its size is not sealed");
  struct stat status{};
  if (::fstat(fd, &status) != 0) return system_error("inspect a received memory file");
  if (static_cast<std::size_t>(status.st_size) != size) return refused("its size is not the announced one");
  return Success{};
}

}  // namespace posix
}  // namespace tzc
