// SPDX-License-Identifier: BSD-3-Clause
#include "channel/publish/in_flight_window.h"

#include <algorithm>
#include <memory>

#include "channel/wire/body.h"
#include "channel/wire/delivery_cursors.h"
#include "segment/ack_word.h"
#include "segment/segment.h"
#include "sync_point/sync_point.h"

namespace tzc {
namespace channel {
namespace {

// What the publisher keeps for each record in flight, about.
constexpr std::size_t record_overhead = 256;

// A record with blocks is retained as bytes: a RecordPtr would keep handles of its blocks.
void retain(const RecordPtr& record, InFlightRecords::Entry& entry) {
  if (record->buffers().empty())
    entry.record = record;
  else
    entry.body.assign(record->data(), record->data() + record->size());
}

}  // namespace

std::size_t InFlightLimit::of_any_size() const {
  return std::min<std::size_t>(records + (buffered_bytes > 0 ? 1 : 0), segment::max_ack_count);
}

std::size_t InFlightLimit::most() const {
  return std::min<std::size_t>(of_any_size() + buffered_bytes / record_overhead, segment::max_ack_count);
}

InFlightWindow::InFlightWindow(const SharedPage& page, AnnouncedSegments& segments, InFlightLimit limit,
                               bool retains)
    : page_(page),
      segments_(segments),
      limit_(limit),
      retains_(retains),
      last_sequence_(first_sequence),
      revoked_through_(first_sequence) {}

/// Counts one more record when it ends.
struct InFlightWindow::Counted {
  InFlightWindow& window;
  ~Counted() {
    if (const std::size_t buffered = window.beyond(window.limit_.of_any_size() - 1))
      window.buffered_bytes_ += window.records_.at(buffered - 1).bytes;
  }
};

// What is pushed counts, also where memory for the rest fails: the record is in flight then, and never written.
void InFlightWindow::push(const RecordPtr& record) {
  InFlightRecords::Entry& entry = records_.push(last_sequence_ + 1);
  ++last_sequence_;
  const Counted counted{*this};
  entry.bytes = record_overhead + record->size();
  if (retains_) retain(record, entry);
  for (const BufferPtr& buffer : record->buffers()) {
    const segment::BlockName block = segment::Segment::name_of(*buffer);
    if (segments_.ack_file_of(block.segment)->mark(block.slot, block.generation))
      entry.marks.push_back(block);
    shared_bytes_ += buffer->size();
    entry.bytes += buffer->size();
    sync_point("publish: marked");
  }
}

bool InFlightWindow::retire_taken() {
  const DeliveryCursors cursors = unpack_cursors(page_.cursors().load(std::memory_order_acquire));
  if (is_after(cursors.taken, last_sequence_)) return false;
  while (size() > 0 && !is_after(records_.oldest().sequence, cursors.taken)) drop_oldest();
  return true;
}

// With one more record, those that are counted in buffered_bytes_ are beyond what may be in flight in any size.
bool InFlightWindow::is_full() const {
  return buffered_bytes_ > limit_.buffered_bytes || size() >= limit_.most();
}

bool InFlightWindow::make_room() {
  if (!retire_taken()) return false;
  while (is_full()) {
    if (!revoke_through(records_.oldest().sequence, drops_.queue)) return false;
  }
  return true;
}

bool InFlightWindow::revoke_buffered() {
  if (size() <= limit_.records) return true;
  if (!retire_taken()) return false;
  while (size() > limit_.records) {
    if (!revoke_through(records_.oldest().sequence, drops_.memory)) return false;
  }
  return true;
}

bool InFlightWindow::revoke_block(const segment::BlockName& block) {
  if (!retire_taken()) return false;
  const InFlightRecords::Entry* entry = records_.find_last(block);
  return entry == nullptr || revoke_through(entry->sequence, drops_.memory);
}

bool InFlightWindow::revoke_through(std::uint32_t sequence, std::uint64_t& drops) {
  std::uint32_t taken = 0;
  const bool won = try_revoke(page_.cursors(), sequence, taken);
  sync_point("publish: revoke decided");
  if (!won && is_after(sequence, taken)) return false;  // the subscriber keeps changing the word
  while (size() > 0 && !is_after(records_.oldest().sequence, sequence))
    is_after(records_.oldest().sequence, taken) ? revoke_oldest(drops) : drop_oldest();
  revoked_through_ = sequence;
  return true;
}

// A retained record is rebuilt before its marks go: until then the marks keep its blocks.
bool InFlightWindow::end() {
  std::uint32_t taken = 0;
  if (size() > 0) try_revoke(page_.cursors(), last_sequence_, taken);
  const bool honest = retire_taken();
  while (size() > 0) {
    const bool comes_back = retains_ && rebuild(records_.oldest());
    revoke_oldest(drops_.end);
    if (comes_back) --drops_.end;
  }
  revoked_through_ = last_sequence_;
  return honest;
}

bool InFlightWindow::rebuild(const InFlightRecords::Entry& entry) {
  if (entry.record) {
    undelivered_.push_back(entry.record);
    return true;
  }
  ParsedBody parsed{};
  parse_body(entry.body.data(), entry.body.size(), parsed);
  std::vector<BufferPtr> buffers;
  for (std::uint32_t i = 0; i < parsed.header.block_count; ++i) {
    buffers.push_back(segments_.revive(parsed.refs[i]));
    if (!buffers.back()) return false;
  }
  undelivered_.push_back(std::make_shared<const Record>(parsed.header, parsed.control, buffers));
  return true;
}

void InFlightWindow::drop_oldest() {
  if (beyond(limit_.of_any_size() - 1) > 0) buffered_bytes_ -= records_.oldest().bytes;
  records_.drop_oldest();
}

void InFlightWindow::revoke_oldest(std::uint64_t& drops) {
  for (const segment::BlockName& block : records_.oldest().marks) segments_.revoke(block);
  ++drops;
  drop_oldest();
}

}  // namespace channel
}  // namespace tzc
