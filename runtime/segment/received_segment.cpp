// SPDX-License-Identifier: BSD-3-Clause
#include "segment/received_segment.h"

#include <algorithm>
#include <cstring>

#include "posix/memory_file.h"
#include "segment/ack_word.h"
#include "segment/registry.h"
#include "segment/size_class.h"

namespace tzc {
namespace segment {
namespace {

constexpr std::uint32_t max_slots = 1 << 20;

Refusal refused(const char* what) {
  Error error;
  error.what = std::string("refuse a received segment: ") + what;
  error.hint = "the publisher is not a TZC process of this version";
  return Refusal(std::move(error));
}

bool is_plausible(const SegmentOffer& offer) {
  return offer.slots > 0 && offer.slots <= max_slots && offer.file_size <= SIZE_MAX / 2 &&
         offer.size >= payloads_offset(offer.slots, posix::page_size()) && offer.size <= offer.file_size &&
         offer.offset <= offer.file_size - offer.size && offer.offset % posix::page_size() == 0 &&
         offer.ack_size >= ack_file_bytes(offer.slots) && offer.ack_size <= SIZE_MAX / 2;
}

bool check_ack_header(const posix::Mapping& mapping, const SegmentOffer& offer) {
  const auto* header = reinterpret_cast<const AckHeader*>(mapping.data());
  return header->magic == ack_magic && header->version == layout_version && header->slots == offer.slots;
}

}  // namespace

bool check_segment_header(const std::uint8_t* bytes, const SegmentOffer& offer) {
  SegmentHeader header;
  std::memcpy(&header, bytes, sizeof header);
  return header.magic == segment_magic && header.version == layout_version && header.slots == offer.slots &&
         header.id == offer.id && header.size == offer.size;
}

// What was sent is checked before anything is mapped: that the files exist, have their size and may be mapped as they are below.
// A mapping that fails then fails for want of memory or of mappings, or because a sandbox forbids it.
OpenedSegment ReceivedSegment::open(const SegmentOffer& offer, posix::FileDescriptor data,
                                    posix::FileDescriptor acknowledgements, ViewWrites writes,
                                    WriteListener* listener) {
  if (!is_plausible(offer)) return refused("its sizes don't agree");
  const Status data_ok = posix::check_received(data.get(), offer.file_size, posix::Sharing::peers_read);
  if (!data_ok) return Refusal(data_ok.error());
  const Status acks_ok =
      posix::check_received(acknowledgements.get(), offer.ack_size, posix::Sharing::peers_write);
  if (!acks_ok) return Refusal(acks_ok.error());
  auto data_map = posix::Mapping::map(data.get(), offer.size, posix::Access::read_only, offer.offset);
  if (!data_map) return data_map.error();
  auto ack_map = posix::Mapping::map(acknowledgements.get(), offer.ack_size, posix::Access::read_write);
  if (!ack_map) return ack_map.error();
  if (!check_segment_header(data_map->data(), offer))
    return refused("its header is of another kind or version");
  if (!check_ack_header(*ack_map, offer))
    return refused("its acknowledgements are of another kind or version");

  auto segment = std::make_shared<ReceivedSegment>();
  segment->writes_ = writes;
  const Status mapped = segment->map_views(data.get(), offer, listener);
  if (!mapped) return mapped.error();
  segment->id_ = offer.id;
  segment->data_ = std::move(*data_map);
  segment->acknowledgements_ = std::move(*ack_map);
  segment->acks_ = AckView(segment->acknowledgements_.data(), offer.slots);
  segment->add_range(segment->data_.data());
  if (segment->views_) segment->add_views();
  return segment;
}

Status ReceivedSegment::map_views(int fd, const SegmentOffer& offer, WriteListener* listener) {
  if (writes_ != ViewWrites::private_pages) return Success{};
  auto mapping = posix::Mapping::map(fd, offer.size, posix::Access::read_private, offer.offset);
  if (!mapping) return mapping.error();
  auto views = PrivateViews::create(std::move(*mapping), listener);
  if (!views) return views.error();
  views_ = std::move(*views);
  return Success{};
}

void ReceivedSegment::add_range(const std::uint8_t* begin) const {
  registry().add(MappedRange{begin, begin + data_.size(), nullptr});
}

void ReceivedSegment::add_views() {
  add_range(views_->data());
  held_for_child_.resize((acks_.slots() + 63) / 64);
  copy_at_forks(*this);
}

ReceivedSegment::~ReceivedSegment() {
  if (data_.data() == nullptr) return;
  if (views_) forget_at_forks(*this);
  registry().remove(data_.data());
  if (views_) registry().remove(views_->data());
}

bool ReceivedSegment::check(const BlockRef& ref) const {
  if (ref.slot >= acks_.slots() || ref.size > data_.size() || ref.offset > data_.size() - ref.size)
    return false;
  const std::size_t page = posix::page_size();
  const std::uint64_t alignment = has_own_pages(ref.size, page) ? page : cache_line;
  if (ref.offset < payloads_offset(acks_.slots(), page) || ref.offset % alignment != 0) return false;
  BlockHeader header;
  std::memcpy(&header, data_.data() + block_header_offset(ref.slot), sizeof header);
  return header.magic == block_magic && header.generation == ref.generation && header.slot == ref.slot &&
         header.offset == ref.offset && header.size == ref.size;
}

ConstBlock ReceivedSegment::block(const BlockRef& ref) const {
  return ConstBlock{data_.data() + ref.offset, static_cast<std::size_t>(ref.size)};
}

bool ReceivedSegment::begin_view(const BlockRef& ref, ConstBlock& view) {
  if (!views_ || !has_own_pages(ref.size, posix::page_size()) || !views_->begin(ref.offset, ref.size))
    return false;
  view = ConstBlock{views_->data() + ref.offset, static_cast<std::size_t>(ref.size)};
  return true;
}

bool ReceivedSegment::end_view(const BlockRef& ref) {
  return views_->end(ref.offset, ref.size);
}

bool ReceivedSegment::take(const BlockRef& ref) {
  return segment::take(acks_.word(ref.slot), ref.generation);
}

void ReceivedSegment::release(const BlockRef& ref) {
  release(ref.slot, ref.generation);
}

void ReceivedSegment::release(std::uint32_t slot, std::uint32_t generation) {
  segment::release(acks_.word(slot), generation);
  add_hint(acks_.released(), acks_.leaf(slot / 64), slot, acks_.slots());
}

// Of a block that was never taken, or is released now, no message shows anything. Small ones, which messages have copied, are
// held along with the others.
bool ReceivedSegment::hold_for_child() noexcept {
  bool any = false;
  for (std::uint32_t slot = 0; slot < acks_.slots(); ++slot) {
    auto& word = acks_.word(slot);
    if (unpack(word.load(std::memory_order_acquire)).taken == 0 || !take_again(word)) continue;
    held_for_child_[slot / 64] |= std::uint64_t{1} << slot % 64;
    any = true;
  }
  return any;
}

// What is taken keeps its generation.
void ReceivedSegment::release_for_child() noexcept {
  for (std::uint32_t slot = 0; slot < acks_.slots(); ++slot) {
    if ((held_for_child_[slot / 64] >> slot % 64 & 1) == 0) continue;
    release(slot, unpack(acks_.word(slot).load(std::memory_order_acquire)).generation);
  }
  std::fill(held_for_child_.begin(), held_for_child_.end(), 0);
}

}  // namespace segment
}  // namespace tzc
