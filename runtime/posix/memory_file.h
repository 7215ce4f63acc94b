// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>

#include "posix/file_descriptor.h"
#include "posix/memory_budget.h"
#include "tzc/error.h"

namespace tzc {
namespace posix {

/// How much a peer that receives the file may do with it.
enum class Sharing {
  peers_read,   ///< peers can map it read-only (Linux: sealed against any writable mapping but the creator's)
  peers_write,  ///< peers can map it read-write
};

/// A shared memory file without a name: gone with its last descriptor and mapping, however a process dies.
///
/// On Linux its size is sealed, so no peer can truncate it under us (a SIGBUS). The portable build has no
/// seals: there a peer that receives a writable file is trusted not to truncate it.
struct MemoryFile {
  FileDescriptor descriptor;  ///< for the creator: map it read-write before anything else
  FileDescriptor shared;      ///< what peers get; invalid when they get `descriptor`
  std::size_t size = 0;
  ReservedBytes reserved;  ///< of its pages; a peer's file counts as nothing here

  int shared_fd() const noexcept { return shared ? shared.get() : descriptor.get(); }
};

/// Creates a file of `size` bytes, a multiple of the page size; no page is committed. Call seal() after
/// mapping. Fails with EMFILE when it would not leave enough descriptors to the program (leaves_enough).
Expected<MemoryFile> create_memory_file(const char* name, std::size_t size, Sharing sharing);

/// Creates a file whose creator maps parts of it for writing at any time, so that no seal can forbid that: peers get a
/// read-only descriptor of a file that may not be opened for writing (mode 0400). A process of the same user could change
/// that; it may do with this process what it likes anyway. Its size is sealed; no page is committed. Error: the portable build, no /proc, or a limit on the
/// size of files (ulimit -f); and as above.
Expected<MemoryFile> create_sparse_memory_file(const char* name, std::size_t size);

/// Gives the pages of [offset, offset + bytes) of a sparse file back to the system; they are zero when they are used again.
void give_back(const MemoryFile& file, std::size_t offset, std::size_t bytes) noexcept;

/// Keeps a descriptor of a new memory file only while it lies in TZC's share of the process's descriptors (see above);
/// invalid with errno EMFILE otherwise.
FileDescriptor within_share(FileDescriptor descriptor) noexcept;

/// Closes the door behind the creator's own mapping: from now on the promise of `sharing` holds.
Status seal(MemoryFile& file, Sharing sharing);

/// Commits the pages of [offset, offset + bytes), which were not committed before. The error says what is full: the
/// file system, a limit of the process or of its control group, the ceiling (memory_budget.h). Nothing is lost when it
/// fails.
Status reserve(MemoryFile& file, std::size_t offset, std::size_t bytes);
/// The same, counted in `reserved` in place of the file's own account.
Status reserve(const MemoryFile& file, ReservedBytes& reserved, std::size_t offset, std::size_t bytes);

/// What a receiver must know before it maps a peer's file of `size` bytes: that it is a memory file of that
/// very size, that it may be mapped as `sharing` says, and (on Linux) that the peer cannot truncate it any more.
Status check_received(int fd, std::size_t size, Sharing sharing);

/// Tells one memory file from all others, for as long as it has a descriptor or a mapping.
struct FileIdentity {
  std::uint64_t device = 0;
  std::uint64_t number = 0;
};
inline bool operator<(const FileIdentity& a, const FileIdentity& b) noexcept {
  return a.device != b.device ? a.device < b.device : a.number < b.number;
}
Expected<FileIdentity> identify(int fd);

}  // namespace posix
}  // namespace tzc
