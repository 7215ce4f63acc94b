// SPDX-License-Identifier: BSD-3-Clause
#include "segment/received_segment.h"

#include <cstring>

#include "posix/memory_file.h"
#include "segment/ack_word.h"
#include "segment/registry.h"

namespace tzc {
namespace segment {
namespace {

constexpr std::uint32_t max_slots = 1 << 20;

Error refused(const char* what) {
  Error error;
  error.what = std::string("refuse a received segment: ") + what;
  error.hint = "the publisher is not a TZC process of this version";
  return error;
}

bool is_plausible(const SegmentOffer& offer) {
  return offer.slots > 0 && offer.slots <= max_slots && offer.size >= segment_header_bytes &&
         offer.size <= SIZE_MAX / 2 && offer.ack_size >= ack_file_bytes(offer.slots) &&
         offer.ack_size <= SIZE_MAX / 2;
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

Expected<std::shared_ptr<ReceivedSegment>> ReceivedSegment::open(const SegmentOffer& offer,
                                                                 posix::FileDescriptor data,
                                                                 posix::FileDescriptor acknowledgements) {
  if (!is_plausible(offer)) return refused("its sizes don't agree");
  const Status data_ok = posix::check_received(data.get(), offer.size, posix::Sharing::peers_read);
  if (!data_ok) return data_ok.error();
  const Status acks_ok =
      posix::check_received(acknowledgements.get(), offer.ack_size, posix::Sharing::peers_write);
  if (!acks_ok) return acks_ok.error();
  auto data_map = posix::Mapping::map(data.get(), offer.size, posix::Access::read_only);
  if (!data_map) return data_map.error();
  auto ack_map = posix::Mapping::map(acknowledgements.get(), offer.ack_size, posix::Access::read_write);
  if (!ack_map) return ack_map.error();
  if (!check_segment_header(data_map->data(), offer))
    return refused("its header is of another kind or version");
  if (!check_ack_header(*ack_map, offer))
    return refused("its acknowledgements are of another kind or version");

  auto segment = std::make_shared<ReceivedSegment>();
  segment->id_ = offer.id;
  segment->slots_ = offer.slots;
  segment->data_ = std::move(*data_map);
  segment->acknowledgements_ = std::move(*ack_map);
  registry().add(MappedRange{segment->data_.data(), segment->data_.data() + offer.size, nullptr});
  return segment;
}

ReceivedSegment::~ReceivedSegment() {
  if (data_.data() != nullptr) registry().remove(data_.data());
}

bool ReceivedSegment::check(const BlockRef& ref) const {
  const std::uint64_t first = segment_header_bytes + block_header_bytes;
  if (ref.slot >= slots_ || ref.offset < first || ref.offset % cache_line != 0) return false;
  if (ref.offset > data_.size() || ref.size > data_.size() - ref.offset) return false;
  BlockHeader header;
  std::memcpy(&header, data_.data() + ref.offset - block_header_bytes, sizeof header);
  return header.magic == block_magic && header.generation == ref.generation && header.slot == ref.slot &&
         header.size == ref.size;
}

ConstBlock ReceivedSegment::block(const BlockRef& ref) const {
  return ConstBlock{data_.data() + ref.offset, static_cast<std::size_t>(ref.size)};
}

bool ReceivedSegment::take(const BlockRef& ref) {
  return segment::take(word(ref.slot), ref.generation);
}

void ReceivedSegment::release(const BlockRef& ref) {
  segment::release(word(ref.slot), ref.generation);
  header().releases.fetch_add(1, std::memory_order_release);
}

std::atomic<std::uint64_t>& ReceivedSegment::word(std::uint32_t slot) const {
  return reinterpret_cast<std::atomic<std::uint64_t>*>(acknowledgements_.data() + ack_header_bytes)[slot];
}

AckHeader& ReceivedSegment::header() const {
  return *reinterpret_cast<AckHeader*>(acknowledgements_.data());
}

}  // namespace segment
}  // namespace tzc
