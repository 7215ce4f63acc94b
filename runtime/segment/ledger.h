// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <vector>

#include "posix/hot.h"
#include "posix/mapping.h"
#include "posix/memory_file.h"
#include "segment/layout.h"
#include "tzc/error.h"

namespace tzc {
namespace segment {

/// The publisher's side of one acknowledgement file: what one subscriber holds of one segment. Thread-safe.
///
/// The file's content is not trusted. A word counts only for a block that was really sent to this subscriber
/// (the publisher remembers that privately), so a hostile peer can at most keep what it was given.
class Ledger {
 public:
  static Expected<std::shared_ptr<Ledger>> create(std::uint32_t slots);

  /// The block goes out to this subscriber once more. False: counted to its limit, or the peer corrupts the
  /// word.
  TZC_HOT bool mark(std::uint32_t slot, std::uint32_t generation);
  /// Undoes one mark that the subscriber did not take.
  void revoke(std::uint32_t slot, std::uint32_t generation);
  /// The subscriber may still read the block, now or once it takes it.
  bool holds(std::uint32_t slot, std::uint32_t generation) const;
  /// The subscriber took the block and did not release it yet.
  bool taken(std::uint32_t slot, std::uint32_t generation) const;
  /// The subscriber holds nothing at all. Slow: looks at every slot.
  bool idle() const;
  /// Changes whenever the subscriber released something, or something was revoked. Both counts side by side:
  /// the subscriber chooses one of them.
  std::uint64_t releases() const;

  int fd() const { return file_.shared_fd(); }
  std::size_t file_size() const { return file_.size; }
  /// The descriptor is needed only until the subscriber has it.
  void close_descriptor() { file_.descriptor.reset(); }

 private:
  std::atomic<std::uint64_t>& word(std::uint32_t slot) const;
  AckHeader& header() const;

  posix::MemoryFile file_;
  posix::Mapping mapping_;
  std::uint32_t slots_ = 0;
  std::atomic<std::uint64_t> revocations_{0};
  std::unique_ptr<std::atomic<std::uint32_t>[]> sent_;  // per slot: the last generation that was marked
};

}  // namespace segment
}  // namespace tzc
