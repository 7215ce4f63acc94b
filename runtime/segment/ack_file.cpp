// SPDX-License-Identifier: BSD-3-Clause
#include "segment/ack_file.h"

#include <new>
#include <utility>

#include "posix/shared_memory.h"
#include "segment/ack_word.h"

namespace tzc {
namespace segment {
namespace {

std::size_t round_to_pages(std::size_t bytes) {
  const std::size_t page = posix::page_size();
  return (bytes + page - 1) / page * page;
}

}  // namespace

AckFile::AckFile(std::uint32_t slots, posix::ZeroedMemory sent)
    : reader_(slots),
      sent_memory_(std::move(sent)),
      sent_(reinterpret_cast<std::atomic<std::uint32_t>*>(sent_memory_.data())) {}

Expected<std::shared_ptr<AckFile>> AckFile::create(std::uint32_t slots) {
  const std::size_t size = round_to_pages(ack_file_bytes(slots));
  // All of it is committed: a word must never fault on a full tmpfs.
  auto memory = posix::create_shared_memory("tzc-acknowledgements", size, size, posix::Sharing::peers_write);
  if (!memory) return memory.error();
  auto sent = posix::ZeroedMemory::create(slots * sizeof(std::atomic<std::uint32_t>));
  if (!sent) return sent.error();

  auto ack_file = std::make_shared<AckFile>(slots, std::move(*sent));
  ack_file->file_ = std::move(memory->file);
  ack_file->mapping_ = std::move(memory->mapping);
  ack_file->acks_ = AckView(ack_file->mapping_.data(), slots);
  new (ack_file->mapping_.data()) AckHeader{ack_magic, layout_version, slots, {0}};
  return ack_file;
}

bool AckFile::mark(std::uint32_t slot, std::uint32_t generation) {
  return note_and_mark(sent_[slot], acks_.word(slot), generation);
}

void AckFile::revoke(std::uint32_t slot, std::uint32_t generation) {
  revoke_in_flight(acks_.word(slot), generation);
}

bool AckFile::holds(std::uint32_t slot, std::uint32_t generation) const {
  return may_hold(sent_[slot], acks_.word(slot), generation);
}

bool AckFile::taken(std::uint32_t slot, std::uint32_t generation) const {
  if (sent_[slot].load(std::memory_order_relaxed) != generation) return false;
  const AckCounts counts = unpack(acks_.word(slot).load(std::memory_order_acquire));
  return counts.generation == generation && counts.taken > 0;
}

bool AckFile::idle() const {
  bool idle = true;
  for_each_sent(
      [&](std::uint32_t slot) { idle = idle && !holds(slot, sent_[slot].load(std::memory_order_relaxed)); });
  return idle;
}

std::uint32_t AckFile::next_released() {
  return reader_.next(acks_.released(), [this](std::uint32_t leaf) -> auto& { return acks_.leaf(leaf); });
}

}  // namespace segment
}  // namespace tzc
