// SPDX-License-Identifier: BSD-3-Clause
#include "channel/publish/announced_segments.h"

#include <string>
#include <utility>

namespace tzc {
namespace channel {
namespace {

// The subscriber holds nothing any more.
void detach(segment::Segment& segment, const std::shared_ptr<segment::AckFile>& ack_file) {
  segment.holders().detach(ack_file);
  ack_file->for_each_sent([&segment](std::uint32_t slot) { segment.note_release(slot); });
}

Error memory_of_the_parent() {
  Error error;
  error.what = "share memory of the process that this one was forked from";
  error.hint = "its blocks may be used again at any time: copy the arrays into memory of this process";
  return error;
}

}  // namespace

// Retires first: the record itself may have blocks in a segment that only it needs.
Status AnnouncedSegments::announce(const Record& record, const std::weak_ptr<segment::Revoker>& revoker,
                                   PacketSender& sender, PacketSender::Result& sent) {
  for (const std::uint64_t id : remove_retired()) {
    Outgoing retirement;
    retirement.kind = PacketKind::retire_segment;
    retirement.segment_id = id;
    sent = sender.send(std::move(retirement));
  }
  for (const BufferPtr& buffer : record.buffers()) {
    segment::Segment& segment = segment::Segment::of(*buffer);
    if (find(segment.id()) != nullptr) continue;
    if (buffer->inherited()) return memory_of_the_parent();
    const Status added = add(segment, revoker);
    if (!added) return added;
    Outgoing announcement;
    announcement.kind = PacketKind::segment;
    announcement.segment = entries_.back().segment;
    announcement.ack_file = entries_.back().ack_file;
    sent = sender.send(std::move(announcement));
  }
  return Success{};
}

Status AnnouncedSegments::add(segment::Segment& segment, const std::weak_ptr<segment::Revoker>& revoker) {
  if (entries_.size() >= max_segments) {
    Error error;
    error.what = "offer another segment to a subscriber that already has " + std::to_string(max_segments);
    return error;
  }
  auto ack_file = segment::AckFile::create(segment.file().slots());
  if (!ack_file) return ack_file.error();
  segment.holders().attach(*ack_file, revoker);
  entries_.push_back(Entry{segment.id(), segment::SegmentPtr(&segment), *ack_file});
  return Success{};
}

std::vector<std::shared_ptr<segment::AckFile>> AnnouncedSegments::ack_files() const {
  std::vector<std::shared_ptr<segment::AckFile>> files;
  for (const Entry& entry : entries_) files.push_back(entry.ack_file);
  return files;
}

BufferPtr AnnouncedSegments::revive(const segment::BlockRef& ref) const {
  const Entry* entry = find(ref.segment);
  if (entry == nullptr) return nullptr;
  return entry->segment->revive(ref.offset, segment::BlockName{ref.segment, ref.slot, ref.generation});
}

void AnnouncedSegments::revoke(const segment::BlockName& block) const {
  const Entry* entry = find(block.segment);
  if (entry == nullptr) return;
  entry->ack_file->revoke(block.slot, block.generation);
  entry->segment->note_release(block.slot);
}

// Segments in which no further block is allocated, and of which the subscriber holds nothing.
std::vector<std::uint64_t> AnnouncedSegments::remove_retired() {
  const auto gone = std::stable_partition(entries_.begin(), entries_.end(), [](const Entry& entry) {
    return !entry.segment->retired() || !entry.ack_file->idle();
  });
  std::vector<std::uint64_t> ids;
  for (auto entry = gone; entry != entries_.end(); ++entry) {
    ids.push_back(entry->id);
    detach(*entry->segment, entry->ack_file);
  }
  entries_.erase(gone, entries_.end());
  return ids;
}

void AnnouncedSegments::clear() {
  for (const Entry& entry : entries_) detach(*entry.segment, entry.ack_file);
  entries_.clear();
}

}  // namespace channel
}  // namespace tzc
