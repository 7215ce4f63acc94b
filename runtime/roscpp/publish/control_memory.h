// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tzc/memory.h>

#include <memory>
#include <mutex>

namespace tzc {
namespace detail {

/// Where the control parts of a topic lie that are too large for the connections' rings (decision 404). Apart from the arrays:
/// small blocks that live shortly, between large ones, would keep the room of a whole array. Created with the first such control
/// part; grows as it needs to. Thread-safe.
class ControlMemory final : public MemorySource {
 public:
  explicit ControlMemory(MemoryOptions arrays);
  /// Null when there is no memory: the control part then goes through the socket.
  BufferPtr allocate(std::size_t bytes) override;

 private:
  const std::shared_ptr<SegmentMemory>& memory();

  const MemoryOptions options_;
  std::once_flag created_;
  std::shared_ptr<SegmentMemory> memory_;
};

}  // namespace detail
}  // namespace tzc
