// SPDX-License-Identifier: BSD-3-Clause
// Linux: memfd with seals.
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/vfs.h>
#include <unistd.h>

#include <cerrno>
#include <string>

#include "posix/error.h"
#include "posix/memory_file.h"
#include "posix/size_signal.h"

#ifndef F_SEAL_FUTURE_WRITE
#define F_SEAL_FUTURE_WRITE 0x0010
#endif

#ifndef MFD_NOEXEC_SEAL
#define MFD_NOEXEC_SEAL 0x0008U
#endif

namespace tzc {
namespace posix {
namespace {

constexpr long tmpfs_magic = 0x01021994;  // linux/magic.h

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

// Where vm.memfd_noexec is 2 the kernel refuses files that could be executed; before Linux 6.3 it does not know the flag.
int create_memfd(const char* name) {
  const int fd = ::memfd_create(name, MFD_CLOEXEC | MFD_ALLOW_SEALING | MFD_NOEXEC_SEAL);
  return fd >= 0 || errno != EINVAL ? fd : ::memfd_create(name, MFD_CLOEXEC | MFD_ALLOW_SEALING);
}

// A huge page is reserved when it is touched, so a file of them can fault although its size is sealed.
bool has_ordinary_pages(int fd) {
  struct statfs system{};
  return ::fstatfs(fd, &system) == 0 && static_cast<long>(system.f_type) == tmpfs_magic;
}

bool can_be_mapped(int fd, int seals, Sharing sharing) {
  const int mode = ::fcntl(fd, F_GETFL) & O_ACCMODE;
  if (sharing == Sharing::peers_read) return mode != O_WRONLY;
  return mode == O_RDWR && (seals & (F_SEAL_WRITE | F_SEAL_FUTURE_WRITE)) == 0;
}

}  // namespace

Expected<MemoryFile> create_memory_file(const char* name, std::size_t size, Sharing) {
  const SizeSignalBlocked blocked;
  MemoryFile file;
  file.descriptor = within_share(FileDescriptor(create_memfd(name)));
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

Expected<MemoryFile> create_sparse_memory_file(const char* name, std::size_t size) {
  auto file = create_memory_file(name, size, Sharing::peers_read);
  if (!file) return file.error();
  const std::string itself = "/proc/self/fd/" + std::to_string(file->descriptor.get());
  file->shared = within_share(FileDescriptor(::open(itself.c_str(), O_RDONLY | O_CLOEXEC)));
  if (!file->shared || ::fchmod(file->descriptor.get(), S_IRUSR) != 0)
    return system_error("open a memory file for reading", name);
  if (::fcntl(file->descriptor.get(), F_ADD_SEALS, size_seals | F_SEAL_SEAL) == 0) return file;
  return system_error("seal a memory file");
}

void give_back(const MemoryFile& file, std::size_t offset, std::size_t bytes) noexcept {
  ::fallocate(file.descriptor.get(), FALLOC_FL_PUNCH_HOLE | FALLOC_FL_KEEP_SIZE, static_cast<off_t>(offset),
              static_cast<off_t>(bytes));
}

Status check_received(int fd, std::size_t size, Sharing sharing) {
  const int seals = ::fcntl(fd, F_GET_SEALS);
  if (seals < 0) return refused("it is not a memfd");
  if ((seals & size_seals) != size_seals) return refused("its size is not sealed");
  if (!has_ordinary_pages(fd)) return refused("it has huge pages");
  if (!can_be_mapped(fd, seals, sharing)) return refused("it may not be mapped as it should");
  struct stat status{};
  if (::fstat(fd, &status) != 0) return system_error("inspect a received memory file");
  if (static_cast<std::size_t>(status.st_size) != size) return refused("its size is not the announced one");
  return Success{};
}

}  // namespace posix
}  // namespace tzc
