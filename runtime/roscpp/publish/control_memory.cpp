// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/publish/control_memory.h"

#include <utility>

namespace tzc {
namespace detail {
namespace {

MemoryOptions that_grow(MemoryOptions options) {
  options.size = 0;
  if (options.prefault == Prefault::all) options.prefault = Prefault::on_first_use;
  return options;
}

}  // namespace

ControlMemory::ControlMemory(MemoryOptions arrays) : options_(that_grow(std::move(arrays))) {}

BufferPtr ControlMemory::allocate(std::size_t bytes) {
  const std::shared_ptr<SegmentMemory>& memory = this->memory();
  return memory ? memory->allocate(bytes) : nullptr;
}

// Without it, control parts go through the socket for good: what it lacks, its publisher's arrays lack, too.
const std::shared_ptr<SegmentMemory>& ControlMemory::memory() {
  std::call_once(created_, [this] {
    if (auto created = SegmentMemory::create(options_)) memory_ = std::move(*created);
  });
  return memory_;
}

}  // namespace detail
}  // namespace tzc
