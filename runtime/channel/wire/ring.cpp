// SPDX-License-Identifier: BSD-3-Clause
#include "channel/wire/ring.h"

#include <cstring>

#include "posix/futex.h"
#include "sync_point/sync_point.h"

namespace tzc {
namespace channel {
namespace {

RingWords<std::atomic<std::uint32_t>&> words_of(Ring& ring) {
  return {ring.publisher.bell,      ring.publisher.written, ring.publisher.packets,
          ring.subscriber.sleeping, ring.subscriber.read,   ring.subscriber.packets_read};
}

}  // namespace

bool RingWriter::write(const void* prefix, std::size_t prefix_size, const void* body, std::size_t body_size) {
  if (ring_ == nullptr || prefix_size + body_size > slot_bytes) return false;
  auto words = words_of(*ring_);
  if (!ring_takes(words, ring_slots, written_, packets_)) return false;
  Ring::Slot& slot = ring_->slots[written_ % ring_slots];
  std::memcpy(slot.bytes, prefix, prefix_size);
  std::memcpy(slot.bytes + prefix_size, body, body_size);
  slot.size.store(static_cast<std::uint32_t>(prefix_size + body_size), std::memory_order_relaxed);
  sync_point("publish: slot filled");
  announce_record(words, ++written_);
  sync_point("publish: before bell");
  bell_.pull(*ring_);
  return true;
}

void RingWriter::sent_packets(std::uint32_t count) {
  if (ring_ == nullptr || ring_start + count == packets_) return;
  packets_ = ring_start + count;
  auto words = words_of(*ring_);
  announce_packets(words, packets_);
  bell_.pull(*ring_);
}

bool RingWriter::all_packets_read() const {
  return ring_ != nullptr && ring_->subscriber.packets_read.load(std::memory_order_acquire) == packets_;
}

Source RingReader::await(const std::atomic<bool>& ended, bool wait) {
  if (ring_ == nullptr) return Source::socket;
  auto words = words_of(*ring_);
  for (;;) {
    const std::uint32_t heard = listen(words);
    const Source source = next_source(words, read_, packets_read_, ended.load(), written_);
    if (source != Source::nothing || !wait) return source;
    wait_for_bell(words, heard,
                  [this](std::uint32_t value) { posix::sleep_while(ring_->publisher.bell, value); });
  }
}

std::size_t RingReader::read(void* memory) {
  if (written_ - read_ > ring_slots) return 0;
  const Ring::Slot& slot = ring_->slots[read_ % ring_slots];
  const std::size_t size = slot.size.load(std::memory_order_relaxed);
  if (size > slot_bytes) return 0;
  std::memcpy(memory, slot.bytes, size);
  sync_point("take: slot copied");
  auto words = words_of(*ring_);
  give_back_slot(words, ++read_);
  return size;
}

void RingReader::count_packet() {
  if (ring_ == nullptr) return;
  auto words = words_of(*ring_);
  acknowledge_packet(words, ++packets_read_);
}

void BellPull::pull(Ring& ring) const {
  if (doorbell)
    doorbell->ring(number);
  else
    wake_reader(ring);
}

void wake_reader(Ring& ring) {
  auto words = words_of(ring);
  ring_bell(words, [&ring](std::uint32_t) { posix::wake_sleeper(ring.publisher.bell); });
}

}  // namespace channel
}  // namespace tzc
