// SPDX-License-Identifier: BSD-3-Clause
// Comparison and swap of tzc::Array; include <tzc/array.h>.
#pragma once

namespace tzc {

template <class T>
bool operator==(const Array<T>& a, const Array<T>& b) {
  return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin());
}
template <class T>
bool operator!=(const Array<T>& a, const Array<T>& b) {
  return !(a == b);
}
template <class T>
bool operator<(const Array<T>& a, const Array<T>& b) {
  return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
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
  return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin());
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
