// SPDX-License-Identifier: BSD-3-Clause
#include "segment/ledger.h"

#include <new>

#include "segment/ack_word.h"

namespace tzc {
namespace segment {
namespace {

std::size_t round_to_pages(std::size_t bytes) {
  const std::size_t page = posix::page_size();
  return (bytes + page - 1) / page * page;
}

}  // namespace

Expected<std::shared_ptr<Ledger>> Ledger::create(std::uint32_t slots) {
  const auto sharing = posix::Sharing::peers_write;
  auto file =
      posix::create_memory_file("tzc-acknowledgements", round_to_pages(ack_file_bytes(slots)), sharing);
  if (!file) return file.error();
  auto mapping = posix::Mapping::map(file->descriptor.get(), file->size, posix::Access::read_write);
  if (!mapping) return mapping.error();
  const Status reserved = posix::reserve(*file, 0, file->size);  // a word must never fault on a full tmpfs
  if (!reserved) return reserved.error();
  const Status sealed = posix::seal(*file, sharing);
  if (!sealed) return sealed.error();

  auto ledger = std::make_shared<Ledger>();
  ledger->file_ = std::move(*file);
  ledger->mapping_ = std::move(*mapping);
  ledger->slots_ = slots;
  ledger->sent_.reset(new std::atomic<std::uint32_t>[slots]());
  new (ledger->mapping_.data()) AckHeader{ack_magic, layout_version, slots, {0}};
  return ledger;
}

// Relaxed: whoever asks holds() for this generation has synchronised with the sender through the last
// BufferPtr.
bool Ledger::mark(std::uint32_t slot, std::uint32_t generation) {
  sent_[slot].store(generation, std::memory_order_relaxed);
  return mark_in_flight(word(slot), generation);
}

void Ledger::revoke(std::uint32_t slot, std::uint32_t generation) {
  revoke_in_flight(word(slot), generation);
  revocations_.fetch_add(1, std::memory_order_release);
}

bool Ledger::holds(std::uint32_t slot, std::uint32_t generation) const {
  if (sent_[slot].load(std::memory_order_relaxed) != generation) return false;
  return !is_idle(word(slot).load(std::memory_order_acquire), generation);
}

bool Ledger::taken(std::uint32_t slot, std::uint32_t generation) const {
  if (sent_[slot].load(std::memory_order_relaxed) != generation) return false;
  const AckCounts counts = unpack(word(slot).load(std::memory_order_acquire));
  return counts.generation == generation && counts.taken > 0;
}

bool Ledger::idle() const {
  for (std::uint32_t slot = 0; slot < slots_; ++slot) {
    const std::uint32_t generation = sent_[slot].load(std::memory_order_relaxed);
    if (generation != 0 && holds(slot, generation)) return false;
  }
  return true;
}

std::uint64_t Ledger::releases() const {
  const std::uint64_t by_subscriber = header().releases.load(std::memory_order_acquire);
  return by_subscriber << 32 | static_cast<std::uint32_t>(revocations_.load(std::memory_order_acquire));
}

std::atomic<std::uint64_t>& Ledger::word(std::uint32_t slot) const {
  return reinterpret_cast<std::atomic<std::uint64_t>*>(mapping_.data() + ack_header_bytes)[slot];
}

AckHeader& Ledger::header() const {
  return *reinterpret_cast<AckHeader*>(mapping_.data());
}

}  // namespace segment
}  // namespace tzc
