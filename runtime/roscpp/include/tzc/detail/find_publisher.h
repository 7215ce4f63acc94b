// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace tzc {

/// The publisher under a key of a map (std::map, std::unordered_map and the like); an empty publisher when
/// there is none. Unlike operator[] it adds no entry.
template <class Map>
const typename Map::mapped_type& find_publisher(const Map& publishers, const typename Map::key_type& key) {
  static const typename Map::mapped_type none{};
  const auto found = publishers.find(key);
  return found == publishers.end() ? none : found->second;
}

}  // namespace tzc
