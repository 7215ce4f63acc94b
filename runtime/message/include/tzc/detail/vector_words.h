// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstring>
#include <memory>
#include <type_traits>
#include <vector>

namespace tzc {
namespace detail {

/// The three pointers that libstdc++'s and libc++'s std::vector consist of. Reading and setting them lets a
/// vector borrow memory that it does not own, or give its memory away, without a copy.
///
/// Code that sets a vector to memory that std::allocator did not make must clear() the vector before its
/// destructor runs.
struct VectorWords {
  void* begin;
  void* end;
  void* end_of_storage;

  static VectorWords of(const void* vector) {
    VectorWords words;
    std::memcpy(&words, vector, sizeof words);
    return words;
  }
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wstringop-overflow"  // GCC 12 takes the vector for its first pointer
#endif
  void write_to(void* vector) const { std::memcpy(vector, this, sizeof *this); }
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif
  static void clear(void* vector) { VectorWords{nullptr, nullptr, nullptr}.write_to(vector); }
};

/// True when a vector of this type has room for exactly the three pointers and no allocator state. False in
/// _GLIBCXX_DEBUG mode, with other allocators, and for std::vector<bool>: such vectors are copied.
template <class Vector>
struct HasVectorWords
    : std::integral_constant<bool, sizeof(Vector) == sizeof(VectorWords) &&
                                       alignof(Vector) == alignof(VectorWords) &&
                                       !std::is_same<typename Vector::value_type, bool>::value &&
                                       std::is_same<typename Vector::allocator_type,
                                                    std::allocator<typename Vector::value_type> >::value> {};

/// Checks on a live vector that its words are begin, end and end of capacity.
inline bool vector_words_are_as_expected() {
  std::vector<int> sample(3);
  sample.reserve(7);
  if (!HasVectorWords<std::vector<int> >::value) return false;
  const VectorWords words = VectorWords::of(&sample);
  return words.begin == sample.data() && words.end == sample.data() + sample.size() &&
         words.end_of_storage == sample.data() + sample.capacity();
}

/// Whether vectors of this type can lend and borrow memory; otherwise the caller copies.
template <class Vector>
bool can_use_vector_words() {
  static const bool as_expected = vector_words_are_as_expected();
  return HasVectorWords<Vector>::value && as_expected;
}

}  // namespace detail
}  // namespace tzc
