// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tzc/array.h>
#include <tzc/memory.h>

#include <cstddef>
#include <memory>

namespace tzc {
namespace message {
namespace detail {

/// Arrays and copies inside a block start at cache lines.
constexpr std::size_t block_alignment = 64;

constexpr std::size_t aligned(std::size_t bytes) {
  return (bytes + block_alignment - 1) / block_alignment * block_alignment;
}

/// Places the arrays of one message in one buffer: measure all, acquire, place all in the same order.
class Placement {
 public:
  explicit Placement(const std::shared_ptr<MemorySource>& memory) : memory_(memory) {}

  template <class T>
  void measure(Array<T>& array) {
    array.bind(memory_);
    size_ += aligned(array.storage().elements_to_place() * sizeof(T));
  }

  /// False when there is no memory for what was measured, or none at all.
  bool acquire() {
    if (!memory_) return false;
    if (size_ == 0) return true;
    buffer_ = memory_->allocate(size_);
    return static_cast<bool>(buffer_);
  }

  template <class T>
  void place(Array<T>& array) {
    const std::size_t elements = array.storage().elements_to_place();
    if (elements == 0) return;
    array.storage().place(buffer_, buffer_->data() + used_);
    used_ += aligned(elements * sizeof(T));
  }

 private:
  const std::shared_ptr<MemorySource>& memory_;
  BufferPtr buffer_;
  std::size_t size_ = 0;
  std::size_t used_ = 0;
};

}  // namespace detail
}  // namespace message
}  // namespace tzc
