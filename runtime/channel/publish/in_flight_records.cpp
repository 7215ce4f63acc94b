// SPDX-License-Identifier: BSD-3-Clause
#include "channel/publish/in_flight_records.h"

#include <algorithm>

namespace tzc {
namespace channel {
namespace {

// One is more than a hundred bytes, and there are thousands of connections.
constexpr std::size_t initial_entries = 1;
constexpr std::size_t usual_body_bytes = 1024;   // larger ones don't stay allocated
constexpr std::size_t most_idle_entries = 1024;  // nor the ring of a subscriber that was stopped for long

bool refers_to(const InFlightRecords::Entry& entry, const segment::BlockName& block) {
  return std::find(entry.marks.begin(), entry.marks.end(), block) != entry.marks.end();
}

}  // namespace

void InFlightRecords::grow() {
  std::vector<Entry> larger(ring_.empty() ? initial_entries : 2 * ring_.size());
  for (std::size_t i = 0; i < size_; ++i) larger[i] = std::move(ring_[(first_ + i) & (ring_.size() - 1)]);
  ring_ = std::move(larger);
  first_ = 0;
}

void InFlightRecords::drop_oldest() {
  Entry& entry = ring_[first_];
  entry.marks.clear();
  if (entry.body.capacity() > usual_body_bytes) std::vector<std::uint8_t>().swap(entry.body);
  entry.body.clear();
  entry.record.reset();
  first_ = (first_ + 1) & (ring_.size() - 1);
  --size_;
  if (size_ > 0 || ring_.size() <= most_idle_entries) return;
  std::vector<Entry>().swap(ring_);
  first_ = 0;
}

const InFlightRecords::Entry* InFlightRecords::find_last(const segment::BlockName& block) const {
  for (std::size_t i = size_; i > 0; --i) {
    const Entry& entry = at(i - 1);
    if (refers_to(entry, block)) return &entry;
  }
  return nullptr;
}

}  // namespace channel
}  // namespace tzc
