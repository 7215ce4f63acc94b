// SPDX-License-Identifier: BSD-3-Clause
#include "segment/segment_pages.h"

#include <utility>

#include "posix/shared_memory.h"

namespace tzc {
namespace segment {

SegmentPages::Part::~Part() {
  if (!pool || mapping.data() == nullptr) return;
  const std::size_t size = mapping.size();
  mapping = posix::Mapping();
  pool->give_back(offset, size);
}

Expected<SegmentPages> SegmentPages::create(std::size_t size, bool pooled) {
  std::shared_ptr<MemoryPool> pool = pooled ? MemoryPool::of_process() : nullptr;
  const std::uint64_t offset = pool ? pool->take(size) : Extents::none;
  if (offset == Extents::none) return create_own(size);
  auto mapping = posix::Mapping::map(pool->file().descriptor.get(), size, posix::Access::read_write, offset);
  if (!mapping) {
    pool->give_back(offset, size);
    return mapping.error();
  }
  SegmentPages pages;
  pages.part_.pool = std::move(pool);
  pages.part_.offset = offset;
  pages.part_.mapping = std::move(*mapping);
  return {std::move(pages)};
}

Expected<SegmentPages> SegmentPages::create_own(std::size_t size) {
  auto memory = posix::create_shared_memory("tzc-segment", size, 0, posix::Sharing::peers_read);
  if (!memory) return memory.error();
  SegmentPages pages;
  pages.own_ = std::move(memory->file);
  pages.part_.mapping = std::move(memory->mapping);
  return {std::move(pages)};
}

Status SegmentPages::reserve(std::size_t offset, std::size_t bytes) {
  return posix::reserve(file(), reserved_, static_cast<std::size_t>(part_.offset) + offset, bytes);
}

}  // namespace segment
}  // namespace tzc
