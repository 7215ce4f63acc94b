// SPDX-License-Identifier: BSD-3-Clause
#include "channel/wait/watchers.h"

namespace tzc {
namespace channel {

std::uint64_t Watchers::add(std::shared_ptr<Watcher> watcher) {
  entries_[++next_key_].watcher = std::move(watcher);
  return next_key_;
}

std::shared_ptr<Watcher> Watchers::find(std::uint64_t key) const {
  const auto found = entries_.find(key);
  return found == entries_.end() ? nullptr : found->second.watcher;
}

std::shared_ptr<Watcher> Watchers::remove(std::uint64_t key) {
  const auto found = entries_.find(key);
  if (found == entries_.end()) return nullptr;
  due_.erase({found->second.deadline, key});
  auto watcher = std::move(found->second.watcher);
  entries_.erase(found);
  return watcher;
}

bool Watchers::set_deadline(std::uint64_t key, Clock::time_point when) {
  const auto found = entries_.find(key);
  if (found == entries_.end()) return false;
  due_.erase({found->second.deadline, key});
  found->second.deadline = when;
  const auto place = due_.emplace(when, key).first;
  return place == due_.begin();
}

std::shared_ptr<Watcher> Watchers::take_due(Clock::time_point now) {
  if (first_deadline() > now) return nullptr;
  Entry& entry = entries_.at(due_.begin()->second);
  due_.erase(due_.begin());
  entry.deadline = Clock::time_point::max();
  return entry.watcher;
}

Watchers::Clock::time_point Watchers::first_deadline() const {
  return due_.empty() ? Clock::time_point::max() : due_.begin()->first;
}

}  // namespace channel
}  // namespace tzc
