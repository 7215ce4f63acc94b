// SPDX-License-Identifier: BSD-3-Clause
#include "channel/publish/outbox.h"

#include <cstring>
#include <iterator>

#include "channel/wire/delivery_cursors.h"
#include "posix/hot.h"
#include "segment/segment.h"
#include "sync_point/sync_point.h"

namespace tzc {
namespace channel {
namespace {

using posix::SendResult;

iovec part(const void* data, std::size_t size) {
  return iovec{const_cast<void*>(data), size};
}

SendResult counted(SendResult result, std::size_t bytes, Traffic& traffic) {
  if (result != SendResult::sent) return result;
  traffic.bytes += bytes;
  ++traffic.packets;
  return result;
}

template <class Packet>
SendResult write_packet(int socket, const Packet& packet, Traffic& traffic, const int* descriptors = nullptr,
                        std::size_t count = 0) {
  const iovec whole = part(&packet, sizeof packet);
  const SendResult result = posix::send_packet(socket, &whole, 1, descriptors, count);
  return counted(result, sizeof packet, traffic);
}

SendResult write_segment(int socket, const Outgoing& item, Traffic& traffic) {
  const segment::Segment& segment = *item.segment;
  const segment::SegmentPages& pages = segment.file().pages();
  const SegmentPacket packet{PacketKind::segment,
                             0,
                             {segment.id(), segment.file().size(), item.ack_file->file_size(),
                              pages.file_size(), pages.offset(), segment.file().slots()}};
  const int descriptors[] = {pages.fd(), item.ack_file->fd()};
  const SendResult result = write_packet(socket, packet, traffic, descriptors, 2);
  if (result == SendResult::sent) item.ack_file->close_descriptor();
  return result;
}

template <class Prefix>
SendResult write_slice(int socket, const Prefix& prefix, const std::uint8_t* data, std::size_t size,
                       Traffic& traffic) {
  const iovec parts[] = {part(&prefix, sizeof prefix), part(data, size)};
  const SendResult result = posix::send_packet(socket, parts, 2);
  return counted(result, sizeof prefix + size, traffic);
}

SendResult write_fragments(int socket, Outgoing& item, Traffic& traffic) {
  const Record& record = *item.record;
  while (item.written < record.size()) {
    const std::size_t size = std::min(fragment_bytes, record.size() - item.written);
    const FragmentPrefix prefix{PacketKind::fragment, item.sequence, item.written, record.size()};
    const SendResult result = write_slice(socket, prefix, record.data() + item.written, size, traffic);
    if (result != SendResult::sent) return result;
    item.written += size;
  }
  return SendResult::sent;
}

// One piece of memory is the quicker write: the kernel reads no list of pieces.
TZC_HOT SendResult write_small(int socket, const RecordPrefix& prefix, const Record& record,
                               Traffic& traffic) {
  std::uint8_t packet[sizeof prefix + Record::usual_bytes];
  std::memcpy(packet, &prefix, sizeof prefix);
  std::memcpy(packet + sizeof prefix, record.data(), record.size());
  const SendResult result = posix::send_packet(socket, packet, sizeof prefix + record.size());
  return counted(result, sizeof prefix + record.size(), traffic);
}

}  // namespace

SendResult Outbox::write_record(int socket, const Record& record, std::uint32_t sequence, Traffic& traffic) {
  sync_point("publish: before write");
  const RecordPrefix prefix{PacketKind::record, sequence};
  if (record.size() <= Record::usual_bytes) return write_small(socket, prefix, record, traffic);
  return write_slice(socket, prefix, record.data(), record.size(), traffic);
}

SendResult Outbox::write(int socket, Outgoing& item, Traffic& traffic) {
  switch (item.kind) {
    case PacketKind::segment:
      return write_segment(socket, item, traffic);
    case PacketKind::retire_segment:
      return write_packet(socket, RetireSegment{item.kind, 0, item.segment_id}, traffic);
    default:
      if (item.record->size() > fragment_bytes) return write_fragments(socket, item, traffic);
      return write_record(socket, *item.record, item.sequence, traffic);
  }
}

void Outbox::push(Outgoing item) {
  if (item.kind == PacketKind::record) ++records_;
  items_.push_back(std::move(item));
}

void Outbox::add_handles(const segment::BlockName& block, std::vector<const void*>& handles) const {
  for (const Outgoing& item : items_) {
    if (!item.record) continue;
    for (const BufferPtr& buffer : item.record->buffers())
      if (segment::Segment::name_of(*buffer) == block) handles.push_back(&buffer);
  }
}

SendResult Outbox::flush(int socket, Traffic& traffic) {
  while (!items_.empty()) {
    const SendResult result = write(socket, items_.front(), traffic);
    if (result != SendResult::sent) return result;
    if (items_.front().kind == PacketKind::record) --records_;
    items_.pop_front();
  }
  return SendResult::sent;
}

void Outbox::drop_records_through(std::uint32_t sequence) {
  for (auto item = items_.begin(); item != items_.end();) {
    const bool is_record = item->kind == PacketKind::record;
    if (is_record && is_after(item->sequence, sequence)) return;
    if (is_record) --records_;
    item = is_record ? items_.erase(item) : std::next(item);
  }
}

void Outbox::clear() {
  items_.clear();
  records_ = 0;
}

}  // namespace channel
}  // namespace tzc
