// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace tzc {
namespace segment {

/// The nodes of a std::map, kept for reuse: once it has had as many entries as reserve() was told of, adding and
/// removing allocate no memory, in any order. Not thread-safe.
template <class Map>
class SpareNodes {
 public:
  /// The map may get that many entries. Allocates what is missing for them.
  void reserve(const Map& map, std::size_t entries) {
    if (nodes_.capacity() < entries) nodes_.reserve(2 * entries);
    while (map.size() + nodes_.size() < entries) {
      Map one;
      one.emplace();
      nodes_.push_back(one.extract(one.begin()));
    }
  }

  /// At most as many as are reserved.
  void add(Map& map, typename Map::key_type key, typename Map::mapped_type value) {
    typename Map::node_type node = std::move(nodes_.back());
    nodes_.pop_back();
    node.key() = key;
    node.mapped() = value;
    map.insert(std::move(node));
  }

  /// The entry behind it.
  typename Map::iterator remove(Map& map, typename Map::iterator at) {
    const auto next = std::next(at);
    nodes_.push_back(map.extract(at));
    return next;
  }

 private:
  std::vector<typename Map::node_type> nodes_;
};

}  // namespace segment
}  // namespace tzc
