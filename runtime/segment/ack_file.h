// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <vector>

#include "posix/hot.h"
#include "posix/mapping.h"
#include "posix/memory_file.h"
#include "posix/zeroed_memory.h"
#include "segment/ack_view.h"
#include "segment/layout.h"
#include "segment/release_hints.h"
#include "tzc/error.h"

namespace tzc {
namespace segment {

/// The publisher's side of one acknowledgement file: what one subscriber holds of one segment. Thread-safe.
///
/// The file's content is not trusted. A word counts only for a block that was really sent to this subscriber
/// (the publisher remembers that privately), so a hostile peer can at most keep what it was given.
class AckFile {
 public:
  AckFile(std::uint32_t slots, posix::ZeroedMemory sent);
  static Expected<std::shared_ptr<AckFile>> create(std::uint32_t slots);

  /// The block goes out to this subscriber once more. False: counted to its limit, or the peer corrupts the
  /// word.
  TZC_HOT bool mark(std::uint32_t slot, std::uint32_t generation);
  /// Undoes one mark that the subscriber did not take.
  void revoke(std::uint32_t slot, std::uint32_t generation);
  /// The subscriber may still read the block, now or once it takes it.
  bool holds(std::uint32_t slot, std::uint32_t generation) const;
  /// The subscriber took the block and did not release it yet.
  bool taken(std::uint32_t slot, std::uint32_t generation) const;
  /// Visits the slot and generation of each block that the subscriber took and did not release yet. Slow: looks at every
  /// slot.
  template <class Visit>
  void for_each_taken(Visit visit) const {
    for_each_sent([&](std::uint32_t slot) {
      const std::uint32_t generation = sent_[slot].load(std::memory_order_relaxed);
      if (taken(slot, generation)) visit(slot, generation);
    });
  }
  /// The subscriber holds nothing at all. Slow: looks at every slot.
  bool idle() const;
  /// A slot that the subscriber says it released something of; no_slot: no more now. For the allocator alone.
  std::uint32_t next_released();
  /// Every slot whose block was ever sent to the subscriber.
  template <class Visit>
  void for_each_sent(Visit visit) const {
    for (std::uint32_t slot = 0; slot < acks_.slots(); ++slot) {
      if (sent_[slot].load(std::memory_order_relaxed) != 0) visit(slot);
    }
  }

  int fd() const { return file_.shared_fd(); }
  std::size_t file_size() const { return file_.size; }
  /// The descriptor is needed only until the subscriber has it.
  void close_descriptor() { file_.descriptor.reset(); }

 private:
  posix::MemoryFile file_;
  posix::Mapping mapping_;
  AckView acks_;
  HintReader reader_;
  // Blocks mostly lie in the first slots, so mostly few pages of this are used.
  const posix::ZeroedMemory sent_memory_;
  std::atomic<std::uint32_t>* const sent_;  // per slot: the last generation that was marked
};

}  // namespace segment
}  // namespace tzc
