// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <vector>

#include "channel/record.h"
#include "posix/hot.h"
#include "segment/block.h"
#include "segment/ledger.h"

namespace tzc {
namespace channel {

/// One block of a record that was sent, and the ledger that counts it.
struct Claim {
  std::shared_ptr<segment::Ledger> ledger;
  segment::BlockName block;
};

/// The records of one connection that neither side has won yet, oldest first. Holds no handles: once a record
/// is written, only its acknowledgement words keep its blocks. Not thread-safe.
class Undecided {
 public:
  struct Entry {
    std::uint32_t sequence = 0;
    std::vector<std::uint8_t> body;  // what it says, if that is kept; its blocks are only named there
    RecordPtr record;                // instead of the body of a record without blocks, which may be large
    std::vector<Claim> claims;
  };

  bool empty() const { return entries_.empty(); }
  std::size_t size() const { return entries_.size(); }
  const Entry& oldest() const { return entries_.front(); }
  /// A new youngest entry without claims.
  TZC_HOT Entry& push(std::uint32_t sequence);
  void drop_newest();
  TZC_HOT void drop_oldest();
  /// The youngest entry that refers to the block; null when there is none.
  const Entry* find_last(const segment::BlockName& block) const;

 private:
  std::deque<Entry> entries_;
  std::vector<Entry> spare_;  // their vectors are reused: the steady state allocates nothing
};

}  // namespace channel
}  // namespace tzc
