// SPDX-License-Identifier: BSD-3-Clause
// Portable: shm_open, unlinked before anyone else can learn the name.
#include <dirent.h>
#include <fcntl.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <memory>

#include "posix/error.h"
#include "posix/memory_file.h"
#include "posix/nonce.h"
#include "posix/size_signal.h"

namespace tzc {
namespace posix {
namespace {

Error refused(const char* what) {
  Error error;
  error.what = std::string("refuse a received memory file: ") + what;
  return error;
}

FileDescriptor open_shm(const std::string& name, int flags) {
  return within_share(FileDescriptor(::shm_open(name.c_str(), flags | O_CLOEXEC, S_IRUSR | S_IWUSR)));
}

// A process killed between shm_open and shm_unlink leaves a name behind. It carries the process id, so that
// the next start can remove the names of the dead. (Should the living one be in another container: it only
// creates anew.)
std::string fresh_name() {
  return "/tzc-" + std::to_string(::getpid()) + "-" + nonce();
}

bool is_of_the_dead(const char* name) {
  int pid = 0;
  return std::sscanf(name, "tzc-%d-", &pid) == 1 && pid > 0 && ::kill(pid, 0) != 0 && errno == ESRCH;
}

bool remove_names_of_the_dead() {
  const std::unique_ptr<DIR, int (*)(DIR*)> entries(::opendir("/dev/shm"), ::closedir);
  while (const dirent* entry = entries ? ::readdir(entries.get()) : nullptr) {
    if (is_of_the_dead(entry->d_name)) ::shm_unlink((std::string("/") + entry->d_name).c_str());
  }
  return true;
}

}  // namespace

Expected<MemoryFile> create_memory_file(const char* name, std::size_t size, Sharing sharing) {
  static const bool removed = remove_names_of_the_dead();
  (void)removed;
  const SizeSignalBlocked blocked;
  const std::string path = fresh_name();
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

Expected<MemoryFile> create_sparse_memory_file(const char* name, std::size_t) {
  Error error;
  error.what = "create a sparse memory file";
  error.where = name;
  error.hint = "there is no portable way to give pages back";
  return error;
}

void give_back(const MemoryFile&, std::size_t, std::size_t) noexcept {}

Status seal(MemoryFile&, Sharing) {
  return Success{};
}

Status check_received(int fd, std::size_t size, Sharing sharing) {
  struct stat status{};
  if (::fstat(fd, &status) != 0) return system_error("inspect a received memory file");
  if (static_cast<std::size_t>(status.st_size) != size) return refused("its size is not the announced one");
  const int mode = ::fcntl(fd, F_GETFL) & O_ACCMODE;
  const bool can_be_mapped = sharing == Sharing::peers_read ? mode != O_WRONLY : mode == O_RDWR;
  return can_be_mapped ? Status(Success{}) : refused("it may not be mapped as it should");
}

}  // namespace posix
}  // namespace tzc
