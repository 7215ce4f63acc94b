// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tzc/detail/sleep_lock.h>
#include <tzc/memory.h>

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace tzc {
namespace message {
template <class M>
struct Traits;
}

/// An array of messages that have data arrays themselves, such as `channels` of a PointCloud. It is a std::vector<T> that binds
/// what it gets to the memory that the message around it is bound to, so that its elements' arrays grow in the segment although
/// the program adds them after `allocate`.
///
/// *Where elements' arrays live.* Elements that resize, emplace_back or the like make are empty, and their arrays grow in the
/// memory. push_back(element) and = copy an element's arrays there; what is moved, or inserted, keeps its memory, and publishing copies
/// what lies on the heap. Only the first `most_bound` elements are bound: each array is a block of its own, and many small ones cost less
/// when publishing gathers them. Elements that are added through a reference to the std::vector are not bound.
///
/// *Publishing* binds it as it binds the arrays of a message that was not allocated (bind_published).
///
/// *Thread-safety and errors* as std::vector's; publishing and copying count as const.
template <class T>
class MessageArray : public std::vector<T> {
  using Vector = std::vector<T>;

 public:
  using typename Vector::const_iterator;
  using typename Vector::iterator;
  using typename Vector::size_type;

  static constexpr size_type most_bound = 64;

  using Vector::Vector;
  MessageArray() = default;
  MessageArray(const Vector& other) : Vector(other) {}
  MessageArray(Vector&& other) noexcept : Vector(std::move(other)) {}
  /// The copy is not bound.
  MessageArray(const MessageArray& other) : Vector(other) {}
  MessageArray(MessageArray&& other) noexcept : Vector(std::move(other)), memory_(std::move(other.memory_)) {}
  ~MessageArray() = default;

  MessageArray& operator=(const MessageArray& other) {
    if (this == &other) return *this;
    return *this = static_cast<const Vector&>(other);
  }
  /// Keeps this object's own binding if it has one.
  MessageArray& operator=(MessageArray&& other) noexcept {
    if (this == &other) return *this;
    if (!memory_) memory_ = std::move(other.memory_);
    return *this = static_cast<Vector&&>(other);
  }
  MessageArray& operator=(const Vector& other) {
    if (!memory_) {
      Vector::operator=(other);
    } else if (this != &other) {
      resize(other.size());
      std::copy(other.begin(), other.end(), this->begin());
    }
    return *this;
  }
  MessageArray& operator=(Vector&& other) noexcept {
    Vector::operator=(std::move(other));
    return bind_from(0);
  }
  MessageArray& operator=(std::initializer_list<T> values) {
    assign(values);
    return *this;
  }

  template <class... Args>
  void assign(Args&&... args) {
    Vector::assign(std::forward<Args>(args)...);
    bind_from(0);
  }
  void assign(std::initializer_list<T> values) { assign(values.begin(), values.end()); }
  template <class... Args>
  void resize(size_type n, Args&&... args) {
    const size_type old = this->size();
    Vector::resize(n, std::forward<Args>(args)...);
    bind_from(old);
  }
  void push_back(const T& value) {
    if (!memory_ || this->size() >= most_bound) return Vector::push_back(value);
    T copy;
    bind_element(copy);
    copy = value;
    Vector::push_back(std::move(copy));
  }
  void push_back(T&& value) { emplace_back(std::move(value)); }
  template <class... Args>
  T& emplace_back(Args&&... args) {
    Vector::emplace_back(std::forward<Args>(args)...);
    bind_from(this->size() - 1);
    return this->back();
  }
  template <class... Args>
  iterator emplace(const_iterator position, Args&&... args) {
    const iterator added = Vector::emplace(position, std::forward<Args>(args)...);
    bind_from(0);
    return added;
  }
  template <class... Args>
  iterator insert(const_iterator position, Args&&... args) {
    const iterator added = Vector::insert(position, std::forward<Args>(args)...);
    bind_from(0);
    return added;
  }
  iterator insert(const_iterator position, std::initializer_list<T> values) {
    return insert(position, values.begin(), values.end());
  }
  /// Exchanges the elements; each object keeps its own binding.
  void swap(MessageArray& other) noexcept {
    Vector::swap(other);
    bind_from(0);
    other.bind_from(0);
  }
  void swap(Vector& other) noexcept {
    Vector::swap(other);
    bind_from(0);
  }

  /// Elements that are added later take memory from `memory`. Those that are there are bound one by one (message::allocate).
  void bind(std::shared_ptr<MemorySource> memory) noexcept { memory_ = std::move(memory); }
  /// The message was published with arrays in `memory`: what is bound already stays so.
  void bind_published(const std::shared_ptr<MemorySource>& memory) const {
    const std::lock_guard<detail::SleepLock> publishing(lock_);
    if (!memory_) memory_ = memory;
  }

 private:
  void bind_element(T& element) const noexcept {
    const auto bind = [this](auto& array) { array.bind(memory_); };
    message::Traits<T>::visit_data(element, bind);
    message::Traits<T>::visit_message_arrays(element, bind);
  }
  MessageArray& bind_from(size_type first) noexcept {
    if (memory_)
      for (size_type i = first; i < std::min(this->size(), +most_bound); ++i) bind_element((*this)[i]);
    return *this;
  }

  mutable std::shared_ptr<MemorySource> memory_;
  mutable detail::SleepLock lock_;
};

template <class T>
constexpr typename MessageArray<T>::size_type MessageArray<T>::most_bound;

template <class T>
void swap(MessageArray<T>& a, MessageArray<T>& b) noexcept {
  a.swap(b);
}
template <class T>
void swap(MessageArray<T>& a, std::vector<T>& b) noexcept {
  a.swap(b);
}
template <class T>
void swap(std::vector<T>& a, MessageArray<T>& b) noexcept {
  b.swap(a);
}

}  // namespace tzc
