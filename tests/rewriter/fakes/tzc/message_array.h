// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <initializer_list>
#include <utility>
#include <vector>
namespace tzc {
template <class T>
class MessageArray : public std::vector<T> {
  using Vector = std::vector<T>;

 public:
  using Vector::Vector;
  MessageArray() = default;
  MessageArray(const Vector& other) : Vector(other) {}
  MessageArray(Vector&& other) noexcept : Vector(std::move(other)) {}
  MessageArray(const MessageArray& other) : Vector(other) {}
  MessageArray(MessageArray&& other) noexcept : Vector(std::move(other)) {}
  MessageArray& operator=(const MessageArray&) { return *this; }
  MessageArray& operator=(MessageArray&&) noexcept { return *this; }
  MessageArray& operator=(const Vector&) { return *this; }
  MessageArray& operator=(Vector&&) noexcept { return *this; }
  MessageArray& operator=(std::initializer_list<T>) { return *this; }
  template <class... Args>
  void assign(Args&&...) {}
  void assign(std::initializer_list<T>) {}
  template <class... Args>
  void resize(typename Vector::size_type, Args&&...) {}
  void push_back(const T&) {}
  void push_back(T&&) {}
  template <class... Args>
  T& emplace_back(Args&&...) {
    return this->back();
  }
  template <class... Args>
  typename Vector::iterator insert(typename Vector::const_iterator, Args&&...) {
    return this->begin();
  }
  void swap(Vector&) noexcept {}
};
}  // namespace tzc
