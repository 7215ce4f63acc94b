// SPDX-License-Identifier: BSD-3-Clause
// Comparison and swap of tzc::Array; include <tzc/array.h>.
#pragma once

namespace tzc {

template <class T>
bool operator==(const Array<T>& a, const Array<T>& b) {
  const T* const first = a.data();  // asked for twice it might have moved meanwhile
  return a.size() == b.size() && std::equal(first, first + a.size(), b.begin());
}
template <class T>
bool operator!=(const Array<T>& a, const Array<T>& b) {
  return !(a == b);
}
template <class T>
bool operator<(const Array<T>& a, const Array<T>& b) {
  const T* const first = a.data();
  const T* const second = b.data();
  return std::lexicographical_compare(first, first + a.size(), second, second + b.size());
}
template <class T>
bool operator>(const Array<T>& a, const Array<T>& b) {
  return b < a;
}
template <class T>
bool operator<=(const Array<T>& a, const Array<T>& b) {
  return !(b < a);
}
template <class T>
bool operator>=(const Array<T>& a, const Array<T>& b) {
  return !(a < b);
}

template <class T, class A>
bool operator==(const Array<T>& a, const std::vector<T, A>& b) {
  const T* const first = a.data();  // asked for twice it might have moved meanwhile
  return a.size() == b.size() && std::equal(first, first + a.size(), b.begin());
}
template <class T, class A>
bool operator==(const std::vector<T, A>& a, const Array<T>& b) {
  return b == a;
}
template <class T, class A>
bool operator!=(const Array<T>& a, const std::vector<T, A>& b) {
  return !(a == b);
}
template <class T, class A>
bool operator!=(const std::vector<T, A>& a, const Array<T>& b) {
  return !(b == a);
}

template <class T>
void swap(Array<T>& a, Array<T>& b) noexcept {
  a.swap(b);
}
template <class T>
void swap(Array<T>& a, std::vector<T>& b) {
  a.swap(b);
}
template <class T>
void swap(std::vector<T>& a, Array<T>& b) {
  b.swap(a);
}

}  // namespace tzc
