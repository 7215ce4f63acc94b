// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <memory>
#include <type_traits>
#include <utility>

namespace tzc {
namespace detail {

/// An element apart from all arrays: on the heap when it is large (a message may hold an array of many megabytes), since a
/// thread's stack may be smaller than it.
template <class T, bool is_large = (sizeof(T) > 4096)>
class ElementCopy {
 public:
  template <class... Args>
  explicit ElementCopy(Args&&... args) : element_(new T(std::forward<Args>(args)...)) {}
  const T& operator*() const noexcept { return *element_; }

 private:
  const std::unique_ptr<const T> element_;
};

template <class T>
class ElementCopy<T, false> {
 public:
  template <class... Args>
  explicit ElementCopy(Args&&... args) : element_(T(std::forward<Args>(args)...)) {}
  const T& operator*() const noexcept { return element_; }

 private:
  const T element_;
};

}  // namespace detail
}  // namespace tzc
