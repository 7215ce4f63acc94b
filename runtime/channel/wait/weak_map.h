// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <iterator>
#include <map>
#include <memory>

namespace tzc {
namespace channel {

/// Objects that others own, by key. Not thread-safe.
template <class Key, class Object>
class WeakMap {
 public:
  /// Null: there is none, or it is gone.
  std::shared_ptr<Object> find(const Key& key) const {
    const auto found = objects_.find(key);
    return found == objects_.end() ? nullptr : found->second.lock();
  }
  /// Also forgets those that are gone.
  void keep(const Key& key, const std::shared_ptr<Object>& object) {
    for (auto each = objects_.begin(); each != objects_.end();)
      each = each->second.expired() ? objects_.erase(each) : std::next(each);
    objects_[key] = object;
  }

  template <class Predicate>
  std::size_t count_if(Predicate predicate) const {
    std::size_t count = 0;
    for (const auto& each : objects_) {
      const auto object = each.second.lock();
      if (object && predicate(*object)) ++count;
    }
    return count;
  }

 private:
  std::map<Key, std::weak_ptr<Object>> objects_;
};

}  // namespace channel
}  // namespace tzc
