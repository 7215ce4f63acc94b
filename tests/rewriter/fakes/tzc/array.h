// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <initializer_list>
#include <vector>
namespace tzc {
struct uninitialized_t {};
constexpr uninitialized_t uninitialized{};
template <class T>
class Array {
 public:
  typedef T value_type;
  typedef T* iterator;
  typedef const T* const_iterator;
  Array() = default;
  explicit Array(std::size_t n) : v_(n) {}
  Array& operator=(const std::vector<T>& v) {
    v_ = v;
    return *this;
  }
  Array& operator=(std::vector<T>&& v) {
    v_ = std::move(v);
    return *this;
  }
  Array& operator=(std::initializer_list<T> values) {
    v_ = values;
    return *this;
  }
  explicit operator std::vector<T>() const { return v_; }
  template <class Vector>
  void copy_to(Vector& vector) const {
    vector.assign(begin(), end());
  }
  void resize(std::size_t n) { v_.resize(n); }
  void resize(std::size_t n, const T& value) { v_.resize(n, value); }
  void resize(std::size_t n, uninitialized_t) { v_.resize(n); }
  void reserve(std::size_t n) { v_.reserve(n); }
  void assign(std::size_t n, const T& value) { v_.assign(n, value); }
  template <class I, class = decltype(*std::declval<I>())>
  void assign(I b, I e) {
    v_.assign(b, e);
  }
  template <class I>
  void insert(const T* at, I b, I e) {
    v_.insert(v_.begin() + (at - v_.data()), b, e);
  }
  T* erase(const T* at, const T* end) {
    const auto first = v_.begin() + (at - v_.data());
    return v_.data() + (v_.erase(first, first + (end - at)) - v_.begin());
  }
  T* erase(const T* at) { return erase(at, at + 1); }
  void push_back(const T& value) { v_.push_back(value); }
  template <class... A>
  void emplace_back(A&&... a) {
    v_.emplace_back(std::forward<A>(a)...);
  }
  void clear() { v_.clear(); }
  void swap(Array& other) { v_.swap(other.v_); }
  void swap(std::vector<T>& v) { v_.swap(v); }
  bool empty() const { return v_.empty(); }
  std::size_t size() const { return v_.size(); }
  T* data() { return v_.data(); }
  const T* data() const { return v_.data(); }
  T* begin() { return v_.data(); }
  T* end() { return v_.data() + v_.size(); }
  const T* begin() const { return v_.data(); }
  const T* end() const { return v_.data() + v_.size(); }
  T& operator[](std::size_t i) { return v_[i]; }
  const T& operator[](std::size_t i) const { return v_[i]; }
  T& at(std::size_t i) { return v_.at(i); }
  const T& at(std::size_t i) const { return v_.at(i); }
  T& front() { return v_.front(); }
  const T& front() const { return v_.front(); }
  T& back() { return v_.back(); }
  const T& back() const { return v_.back(); }

 private:
  std::vector<T> v_;
};
}  // namespace tzc
