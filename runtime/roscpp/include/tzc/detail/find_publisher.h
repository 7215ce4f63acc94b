// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <type_traits>

namespace tzc {
namespace detail {

template <class Sequence>
std::size_t size_of(const Sequence& sequence) {
  return sequence.size();
}
template <class T, std::size_t size>
std::size_t size_of(const T (&)[size]) {
  return size;
}

template <class Publisher>
const Publisher& no_publisher() {
  static const Publisher none{};
  return none;
}

}  // namespace detail

/// The publisher under a key of a map (std::map, std::unordered_map and the like); an empty publisher when
/// there is none. Unlike operator[] it adds no entry.
template <class Map>
const typename Map::mapped_type& find_publisher(const Map& publishers, const typename Map::key_type& key) {
  const auto found = publishers.find(key);
  return found == publishers.end() ? detail::no_publisher<typename Map::mapped_type>() : found->second;
}

/// The publisher at an index of a sequence (an array, std::vector, std::deque, std::array); an empty publisher when the
/// sequence has no such element. Any integer may be asked for, a negative one included.
template <class Sequence, class Index>
auto find_publisher(const Sequence& publishers, Index index) -> decltype(publishers[std::size_t()]) {
  using Publisher = typename std::decay<decltype(publishers[std::size_t()])>::type;
  const auto at = static_cast<std::size_t>(index);
  return at < detail::size_of(publishers) ? publishers[at] : detail::no_publisher<Publisher>();
}

}  // namespace tzc
