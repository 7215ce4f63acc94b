// SPDX-License-Identifier: BSD-3-Clause
#include "segment/segment_file.h"

#include <algorithm>
#include <utility>

#include "segment/layout.h"

namespace tzc {
namespace segment {
namespace {

std::size_t round_up(std::size_t bytes, std::size_t unit) {
  return (bytes + unit - 1) / unit * unit;
}

// One for each page of small payloads; fewer than 64 would limit small segments, more than 65536 buy nothing.
std::uint32_t slots_for(std::size_t payload) {
  return static_cast<std::uint32_t>(std::clamp<std::size_t>(payload / 4096, 64, 65536));
}

}  // namespace

Expected<SegmentFile> SegmentFile::create(std::size_t payload_bytes, Prefault prefault, bool pooled) {
  const std::uint32_t slots = slots_for(payload_bytes);
  const std::size_t begin = payloads_offset(slots, posix::page_size());
  const std::size_t size = begin + round_up(payload_bytes, posix::page_size());
  auto pages = SegmentPages::create(size, pooled);
  if (!pages) return pages.error();
  SegmentFile segment;
  segment.pages_ = std::move(*pages);
  segment.prefault_ = prefault;
  segment.slots_ = slots;
  segment.payloads_.end = begin;
  const bool all = prefault == Prefault::all;
  const Status committed = segment.commit(all ? slots - 1 : 0, all ? segment.size() : begin);
  if (!committed) return committed.error();
  return {std::move(segment)};
}

Status SegmentFile::commit(std::uint32_t slot, std::uint64_t end) {
  const Status headers = commit(headers_, block_header_offset(slot + 1));
  return headers ? commit(payloads_, end) : headers;
}

Status SegmentFile::commit(Committed& part, std::size_t end) {
  if (end <= part.end) return Success{};
  const std::size_t target = std::min(round_up(end, posix::page_size()), size());
  const Status reserved = pages_.reserve(part.end, target - part.end);
  if (!reserved) return reserved;
  if (prefault_ != Prefault::none) pages_.mapping().populate(part.end, target - part.end);
  part.end = target;
  return Success{};
}

}  // namespace segment
}  // namespace tzc
