// SPDX-License-Identifier: BSD-3-Clause
// Portable: shm_open, unlinked before anyone else can learn the name.
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>

#include "posix/error.h"
#include "posix/memory_file.h"
#include "posix/nonce.h"

namespace tzc {
namespace posix {
namespace {

FileDescriptor open_shm(const std::string& name, int flags) {
  return FileDescriptor(::shm_open(name.c_str(), flags | O_CLOEXEC, S_IRUSR | S_IWUSR));
}

}  // namespace

Expected<MemoryFile> create_memory_file(const char* name, std::size_t size, Sharing sharing) {
  const std::string path = std::string("/tzc-") + nonce();
  MemoryFile file;
  file.descriptor = open_shm(path, O_RDWR | O_CREAT | O_EXCL);
  if (!file.descriptor) return system_error("create a shared memory file", name);
  // Peers that only read get a descriptor that was never opened for writing.
  if (sharing == Sharing::peers_read) file.shared = open_shm(path, O_RDONLY);
  const int open_failure = errno;
  ::shm_unlink(path.c_str());
  errno = open_failure;
  if (sharing == Sharing::peers_read && !file.shared)
    return system_error("reopen a shared memory file", name);
  if (::ftruncate(file.descriptor.get(), static_cast<off_t>(size)) != 0)
    return system_error("size a shared memory file to " + std::to_string(size) + " bytes", name);
  file.size = size;
  return file;
}

Status seal(MemoryFile&, Sharing) {
  return Success{};
}

Status check_received(int fd, std::size_t size, Sharing) {
  struct stat status{};
  if (::fstat(fd, &status) != 0) return system_error("inspect a received memory file");
  if (static_cast<std::size_t>(status.st_size) == size) return Success{};
  Error error;
  error.what = "refuse a received memory file: its size is not the announced one";
  return error;
}

}  // namespace posix
}  // namespace tzc
