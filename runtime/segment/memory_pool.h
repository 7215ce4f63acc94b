// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>

#include "posix/memory_file.h"
#include "segment/extents.h"

namespace tzc {
namespace segment {

/// One memory file of this process, of which segments are parts: two descriptors, however many publishers there are.
/// Whoever gets one segment of it can read all, so only segments share it whose publishers admit the same peers
/// (MemoryOptions::pooled). Its pages go back to the system with the segment that they belonged to. Thread-safe.
class MemoryPool {
 public:
  /// The one of this process, in a forked child its own; it lives as long as a segment does. Null: the system has no
  /// such files.
  static std::shared_ptr<MemoryPool> of_process();
  explicit MemoryPool(posix::MemoryFile file);

  /// The offset of a part of so many bytes, whole pages, none committed; Extents::none: no such part is free.
  std::uint64_t take(std::size_t bytes);
  /// In a forked child nothing happens: the file is the parent's.
  void give_back(std::uint64_t offset, std::size_t bytes) noexcept;
  const posix::MemoryFile& file() const { return file_; }

 private:
  const posix::MemoryFile file_;
  const std::uint32_t epoch_;
  std::mutex mutex_;
  Extents free_;
};

}  // namespace segment
}  // namespace tzc
