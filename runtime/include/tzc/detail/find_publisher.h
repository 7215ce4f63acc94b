// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace tzc {

/// The publisher that a map (std::map, std::unordered_map and their like) holds under a key, without adding
/// an entry as operator[] would; an empty publisher when there is none.
template <class Map>
const typename Map::mapped_type& find_publisher(const Map& publishers, const typename Map::key_type& key) {
  static const typename Map::mapped_type none{};
  const auto found = publishers.find(key);
  return found == publishers.end() ? none : found->second;
}

}  // namespace tzc
