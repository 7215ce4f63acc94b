// SPDX-License-Identifier: BSD-3-Clause
// The private half of tzc::Array; include <tzc/array.h>.
#pragma once

#include <cstring>
#include <stdexcept>
#include <string>

namespace tzc {
namespace detail {

/// The text is std::vector's, which programs log. No part of at(), which would be too large to be inlined.
[[noreturn]] inline __attribute__((noinline)) void throw_out_of_range(std::size_t i, std::size_t size) {
  throw std::out_of_range("vector::_M_range_check: __n (which is " + std::to_string(i) +
                          ") >= this->size() (which is " + std::to_string(size) + ")");
}

}  // namespace detail

/// As with std::vector, the elements stay where they are when there is room: pointers to them may be held.
template <class T>
void Array<T>::copy_from(const Array& other) {
  const bool has_room = storage_.is_writable() && other.size() <= capacity();
  if (!has_room && storage_.share_with(other.storage_)) return;
  const T* const first = other.data();  // asked for twice it might have moved meanwhile
  assign(first, first + other.size());
}

template <class T>
void Array<T>::take(std::vector<T>& values) {
  if (detail::can_use_vector_words<std::vector<T> >()) {
    storage_.adopt(values.data(), values.size(), values.capacity());
    detail::VectorWords::clear(&values);
  } else {
    assign(values.begin(), values.end());
    values.clear();
  }
}

template <class T>
std::vector<T> Array<T>::release_to_vector() {
  std::vector<T> values;
  if (storage_.on_heap() && detail::can_use_vector_words<std::vector<T> >()) {
    T* const memory = const_cast<T*>(storage_.begin());
    detail::VectorWords{memory, memory + size(), memory + storage_.heap_capacity()}.write_to(&values);
    storage_.give_up_heap();
  } else {
    values.assign(cbegin(), cend());
    storage_.reset();
  }
  return values;
}

template <class T>
bool Array<T>::bound_buffer_has_room(size_type n) const noexcept {
  return storage_.buffer() && storage_.is_writable() && n <= capacity();
}

/// Memory for n elements that the caller overwrites; keeps no old element.
template <class T>
T* Array<T>::replace(size_type n) {
  if (n == 0) {
    clear();
    return nullptr;
  }
  if (n > capacity() || !storage_.is_writable()) remake_unfilled(checked(n));
  storage_.set_size(n);
  return data();
}

/// Fresh memory without elements. Shared ones are let go first: nothing but their block may be left of a small memory, or a block
/// may be taken from subscribers that they have not read.
template <class T>
void Array<T>::remake_unfilled(size_type capacity) {
  if (storage_.is_shared()) storage_.drop_elements();
  storage_.remake(capacity, 0);
}

/// Appends n elements without values and returns the first of them.
template <class T>
T* Array<T>::grow_by(size_type n) {
  const size_type old = size();
  T* elements = storage_.writable_or_null();
  if (__builtin_expect(elements == nullptr || n > capacity() - old, 0)) elements = make_room(n);
  storage_.set_size(old + n);
  return elements + old;
}

template <class T>
T* Array<T>::make_room(size_type n) {
  storage_.remake(capacity_for(n), size());
  return data();
}

/// Of memory that has room for n elements more.
template <class T>
typename Array<T>::size_type Array<T>::capacity_for(size_type n) const {
  if (n > max_size() - size()) checked(max_size() + 1);
  const size_type needed = size() + n;
  const size_type doubled = size() <= max_size() / 2 ? size() * 2 : max_size();
  return needed <= capacity() ? capacity() : std::max(needed, doubled);
}

/// Room for n elements, which the caller may copy from this array: if they moved, they are in `before`, too.
template <class T>
typename Array<T>::iterator Array<T>::make_gap(const_iterator position, size_type n,
                                               detail::ArrayStorage<T>& before) {
  const difference_type at = position - cbegin();
  const size_type behind = size() - static_cast<size_type>(at);
  const bool has_room = storage_.is_writable() && n <= capacity() - size();
  if (n != 0 && !has_room) storage_.remake(capacity_for(n), size(), before);
  storage_.set_size(size() + n);
  const iterator gap = begin() + at;
  if (n != 0 && behind != 0) std::memmove(static_cast<void*>(gap + n), gap, behind * sizeof(T));
  return gap;
}

/// Elements that are added are T(args...). Those may be one of this array's.
template <class T>
template <class... Args>
void Array<T>::resize_with(size_type n, Args&&... args) {
  if (n <= size()) return storage_.set_size(n);
  const Element added(std::forward<Args>(args)...);
  T* const first = grow_by(n - size());
  std::fill(first, data() + n, *added);
}

template <class T>
typename Array<T>::iterator Array<T>::insert_copies(const_iterator position, size_type n,
                                                    const Element& element) {
  detail::ArrayStorage<T> before;
  const iterator gap = make_gap(position, n, before);
  std::fill_n(gap, n, *element);
  return gap;
}

/// Whether a range may consist of this array's elements. Values that its iterators make may come from them.
template <class T>
template <class It>
bool Array<T>::may_lie_here(It first) const {
  auto&& element = *first;
  return !std::is_lvalue_reference<decltype(*first)>::value || storage_.has(std::addressof(element));
}

template <class T>
template <class It>
void Array<T>::assign_range(It first, It last, std::input_iterator_tag) {
  clear();
  for (; first != last; ++first) push_back(*first);
}

template <class T>
template <class It>
void Array<T>::assign_range(It first, It last, std::forward_iterator_tag) {
  const auto n = static_cast<size_type>(std::distance(first, last));
  const bool has_room = n <= capacity() && storage_.is_writable();
  if (n == 0 || has_room || !may_lie_here(first)) {
    std::copy(first, last, replace(n));
    return;
  }
  detail::ArrayStorage<T> before;
  storage_.remake(checked(n), 0, before);
  storage_.set_size(n);
  std::copy(first, last, data());
}

template <class T>
template <class It>
typename Array<T>::iterator Array<T>::insert_range(const_iterator position, It first, It last,
                                                   std::input_iterator_tag) {
  const Array read(first, last);
  return insert(position, read.begin(), read.end());
}

template <class T>
template <class It>
typename Array<T>::iterator Array<T>::insert_range(const_iterator position, It first, It last,
                                                   std::forward_iterator_tag) {
  detail::ArrayStorage<T> before;
  const iterator gap = make_gap(position, static_cast<size_type>(std::distance(first, last)), before);
  std::copy(first, last, gap);
  return gap;
}

template <class T>
typename Array<T>::size_type Array<T>::checked(size_type n) const {
  if (n > max_size()) throw std::length_error("tzc::Array: more elements than max_size()");
  return n;
}

template <class T>
inline typename Array<T>::size_type Array<T>::expected(size_type i) const noexcept {
#ifdef _GLIBCXX_ASSERTIONS
  __glibcxx_assert(i < size());
#endif
  return i;
}

template <class T>
inline typename Array<T>::size_type Array<T>::in_range(size_type i) const {
  if (__builtin_expect(i >= size(), 0)) detail::throw_out_of_range(i, size());
  return i;
}

}  // namespace tzc
