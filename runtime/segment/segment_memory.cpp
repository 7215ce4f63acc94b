// SPDX-License-Identifier: BSD-3-Clause
#include "posix/memory_budget.h"
#include "segment/segment_memory_impl.h"
#include "tzc/memory.h"
#include "tzc/process_memory.h"

namespace tzc {

SegmentMemory::SegmentMemory(std::unique_ptr<segment::SegmentMemoryImpl> impl) : impl_(std::move(impl)) {}

SegmentMemory::~SegmentMemory() = default;

Expected<std::shared_ptr<SegmentMemory>> SegmentMemory::create(const MemoryOptions& options) {
  auto impl = std::make_unique<segment::SegmentMemoryImpl>(options);
  const Status opened = impl->open();
  if (!opened) return opened.error();
  return std::shared_ptr<SegmentMemory>(new SegmentMemory(std::move(impl)));
}

BufferPtr SegmentMemory::allocate(std::size_t bytes) {
  return impl_->allocate(bytes);
}
MemoryStats SegmentMemory::stats() const {
  return impl_->stats();
}
AllocationError SegmentMemory::last_failure() const {
  return impl_->last_failure();
}
const MemoryOptions& SegmentMemory::options() const {
  return impl_->options();
}

std::uint64_t SegmentMemory::copied_bytes() const noexcept {
  return copied_bytes_.load(std::memory_order_relaxed);
}

void note_copy(MemorySource& memory, std::size_t bytes) noexcept {
  if (auto* own = dynamic_cast<SegmentMemory*>(&memory))
    own->copied_bytes_.fetch_add(bytes, std::memory_order_relaxed);
}

void set_memory_ceiling(std::size_t bytes) {
  posix::set_memory_ceiling(bytes);
}

ProcessMemory process_memory() {
  return {posix::reserved_memory(), posix::memory_ceiling()};
}

}  // namespace tzc
