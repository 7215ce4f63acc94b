// SPDX-License-Identifier: BSD-3-Clause
#include "trace/recent_messages.h"

namespace tzc {
namespace trace {

void RecentMessages::remember(const void* address, std::uint64_t message) {
  if (address == nullptr) return;
  const std::lock_guard<std::mutex> lock(mutex_);
  ring_[next_] = Entry{address, message, false};
  next_ = (next_ + 1) % most;
}

RecentMessages::Entry* RecentMessages::newest(const void* address) {
  if (address == nullptr) return nullptr;
  for (std::size_t age = 1; age <= most; ++age) {
    Entry& entry = ring_[(next_ + most - age) % most];
    if (entry.address == address) return &entry;
  }
  return nullptr;
}

RecentMessages::Found RecentMessages::find(const void* address) {
  const std::lock_guard<std::mutex> lock(mutex_);
  Entry* const entry = newest(address);
  if (entry == nullptr) return Found();
  const Found found{entry->message, !entry->is_called};
  entry->is_called = true;
  return found;
}

std::uint64_t RecentMessages::take(const void* address) {
  const std::lock_guard<std::mutex> lock(mutex_);
  Entry* const entry = newest(address);
  if (entry == nullptr) return 0;
  const std::uint64_t message = entry->message;
  *entry = Entry();
  return message;
}

}  // namespace trace
}  // namespace tzc
