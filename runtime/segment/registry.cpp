// SPDX-License-Identifier: BSD-3-Clause
#include "segment/registry.h"

#include <pthread.h>

#include <algorithm>
#include <mutex>
#include <new>

namespace tzc {
namespace segment {
namespace {

auto first_at_or_after(const std::vector<MappedRange>& ranges, const std::uint8_t* address) {
  return std::lower_bound(ranges.begin(), ranges.end(), address,
                          [](const MappedRange& range, const std::uint8_t* at) { return range.begin < at; });
}

}  // namespace

// A read-write lock remembers which thread locked it, and the child's thread is another one: it cannot unlock.
void Registry::renew_in_child() {
  for (const MappedRange& range : ranges_) {
    if (range.own != nullptr) range.own->make_private();
  }
  new (&mutex_) std::shared_mutex;
}

void Registry::add(const MappedRange& range) {
  const std::unique_lock<std::shared_mutex> lock(mutex_);
  ranges_.insert(first_at_or_after(ranges_, range.begin), range);
}

void Registry::remove(const std::uint8_t* begin) {
  const std::unique_lock<std::shared_mutex> lock(mutex_);
  const auto found = first_at_or_after(ranges_, begin);
  if (found != ranges_.end() && found->begin == begin) ranges_.erase(found);
}

bool Registry::contains(const std::uint8_t* address) const {
  const std::shared_lock<std::shared_mutex> lock(mutex_);
  return range_of(address) != nullptr;
}

// The lock keeps the segment mapped meanwhile: it leaves this list before it goes.
FoundBuffer Registry::find(const std::uint8_t* address, std::size_t bytes) const {
  const std::shared_lock<std::shared_mutex> lock(mutex_);
  const MappedRange* range = range_of(address);
  return range != nullptr && range->own != nullptr ? range->own->find(address, bytes) : FoundBuffer();
}

const MappedRange* Registry::range_of(const std::uint8_t* address) const {
  auto after = first_at_or_after(ranges_, address + 1);
  if (after == ranges_.begin()) return nullptr;
  const MappedRange& range = *std::prev(after);
  return address < range.end ? &range : nullptr;
}

namespace {

// A child must not inherit the lock from a thread that it does not have.
Registry* create_registry() {
  ::pthread_atfork([] { registry().lock(); }, [] { registry().unlock(); },
                   [] { registry().renew_in_child(); });
  return new Registry;
}

}  // namespace

Registry& registry() {
  static Registry* const one = create_registry();
  return *one;
}

}  // namespace segment

FoundBuffer find_in_buffer(const void* address, std::size_t bytes) {
  return segment::registry().find(static_cast<const std::uint8_t*>(address), bytes);
}

BufferPtr find_buffer(const void* address, std::size_t bytes) {
  return find_in_buffer(address, bytes).buffer;
}

bool in_segment(const void* address) {
  return segment::registry().contains(static_cast<const std::uint8_t*>(address));
}

}  // namespace tzc
