// SPDX-License-Identifier: BSD-3-Clause
#include "channel/announced_segments.h"

#include <algorithm>

namespace tzc {
namespace channel {

BufferPtr AnnouncedSegments::revive(const segment::BlockRef& ref) const {
  for (const Entry& entry : entries_) {
    if (entry.id == ref.segment)
      return entry.segment->revive(ref.offset, segment::BlockName{ref.segment, ref.slot, ref.generation});
  }
  return nullptr;
}

Expected<AnnouncedSegments::Entry> AnnouncedSegments::add(segment::Segment& segment,
                                                          const std::weak_ptr<segment::Revoker>& revoker) {
  auto ledger = segment::Ledger::create(segment.slots());
  if (!ledger) return ledger.error();
  segment.attach(*ledger, revoker);
  entries_.push_back(Entry{segment.id(), segment::SegmentPtr(&segment), *ledger});
  return entries_.back();
}

std::vector<std::uint64_t> AnnouncedSegments::remove_retired() {
  const auto gone = std::stable_partition(entries_.begin(), entries_.end(), [](const Entry& entry) {
    return !entry.segment->retired() || !entry.ledger->idle();
  });
  std::vector<std::uint64_t> ids;
  for (auto entry = gone; entry != entries_.end(); ++entry) {
    ids.push_back(entry->id);
    entry->segment->detach(entry->ledger);
  }
  entries_.erase(gone, entries_.end());
  return ids;
}

void AnnouncedSegments::clear() {
  for (const Entry& entry : entries_) entry.segment->detach(entry.ledger);
  entries_.clear();
}

}  // namespace channel
}  // namespace tzc
