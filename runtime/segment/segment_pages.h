// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

#include "posix/mapping.h"
#include "posix/memory_budget.h"
#include "posix/memory_file.h"
#include "segment/memory_pool.h"
#include "tzc/error.h"

namespace tzc {
namespace segment {

/// The pages of one segment, mapped for writing: a memory file of their own, or a part of the process's pool. Not
/// thread-safe.
class SegmentPages {
 public:
  /// `size`: whole pages, none committed. `pooled`: of the pool, where there is one.
  static Expected<SegmentPages> create(std::size_t size, bool pooled);
  SegmentPages() = default;
  SegmentPages(SegmentPages&& other) noexcept = default;
  SegmentPages& operator=(SegmentPages&& other) noexcept = default;

  /// As posix::reserve, counted from the first of these pages.
  Status reserve(std::size_t offset, std::size_t bytes);
  const posix::Mapping& mapping() const { return part_.mapping; }
  /// In a forked child, whose writes must not reach the parent's messages. Does nothing in a child of that child: the pages are
  /// private already, and the descriptor may be another file's by now.
  void make_private() const noexcept {
    is_private_ = is_private_ || mapping().make_private(file_fd(), offset());
  }

  /// What subscribers get.
  int fd() const { return file().shared_fd(); }
  std::uint64_t file_size() const { return file().size; }
  /// Where these pages begin in the file.
  std::uint64_t offset() const { return part_.offset; }

 private:
  /// Unmapped, then given back.
  struct Part {
    Part() = default;
    Part(Part&& other) noexcept = default;
    Part& operator=(Part&& other) noexcept = default;
    ~Part();

    std::shared_ptr<MemoryPool> pool;
    std::uint64_t offset = 0;
    posix::Mapping mapping;
  };

  static Expected<SegmentPages> create_own(std::size_t size);
  const posix::MemoryFile& file() const { return part_.pool ? part_.pool->file() : own_; }
  int file_fd() const { return file().descriptor.get(); }

  posix::MemoryFile own_;  // none: of the pool
  Part part_;
  posix::ReservedBytes reserved_;
  mutable bool is_private_ = false;
};

}  // namespace segment
}  // namespace tzc
