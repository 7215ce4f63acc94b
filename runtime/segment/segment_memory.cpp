// SPDX-License-Identifier: BSD-3-Clause
#include "segment/segment_memory_impl.h"
#include "tzc/memory.h"

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
Error SegmentMemory::last_failure() const {
  return impl_->last_failure();
}
const MemoryOptions& SegmentMemory::options() const {
  return impl_->options();
}

}  // namespace tzc
