// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace tzc {
namespace channel {

/// A vector with inline storage for the `usual` number of elements: the hot path from publish to the callback
/// allocates nothing and touches no further cache lines for them. Beyond that it is a std::vector. Elements are contiguous; push_back may move them. Not thread-safe.
template <class T, std::size_t usual>
class SmallVector {
 public:
  bool empty() const { return size_ == 0; }
  std::size_t size() const { return size_; }
  const T* begin() const { return size_ <= usual ? here_ : elsewhere_.data(); }
  const T* end() const { return begin() + size_; }
  const T& back() const { return *(end() - 1); }

  void push_back(T element) {
    if (size_ < usual) {
      here_[size_++] = std::move(element);
      return;
    }
    if (size_ == usual)
      elsewhere_.assign(std::make_move_iterator(here_), std::make_move_iterator(here_ + usual));
    elsewhere_.push_back(std::move(element));
    ++size_;
  }

  /// What elements own is released now, not when they are overwritten.
  void clear() {
    for (std::size_t i = 0; i < size_ && i < usual; ++i) here_[i] = T();
    elsewhere_.clear();
    size_ = 0;
  }

 private:
  std::size_t size_ = 0;
  T here_[usual] = {};
  std::vector<T> elsewhere_;
};

}  // namespace channel
}  // namespace tzc
