// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstdint>
#include <cstdlib>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <string>

#include "posix/write_fault.h"
#include "segment/block.h"
#include "segment/guard_report.h"
#include "segment/segment_file.h"

namespace tzc {
namespace segment {

/// Guard mode for the blocks of one segment, in the publisher's mapping; each of them has whole pages.
///
///   open --publish--> read-only --put_away--> inaccessible --(a bounded number of blocks later)--> reusable
///
/// A late access is reported and gets private pages, which neither the file nor a subscriber sees; that block is never
/// reused. put_away and cut_quarantine are for the allocator alone; publish is thread-safe.
class SegmentGuard final : public posix::WriteFaultArea {
 public:
  using Reuse = std::function<void(Block&)>;

  /// `file` outlives this; `reuse` is called for blocks that may be used again. Null: no memory for it; the segment goes
  /// unguarded.
  static std::unique_ptr<SegmentGuard> create(const SegmentFile& file, const std::string& topic, Reuse reuse);
  ~SegmentGuard();

  /// The block is read by others from now on.
  void publish(const Block& block) noexcept;
  /// The block is in use no more. It is kept from reuse; others may have been kept long enough.
  void put_away(Block& block);
  /// For want of memory, the oldest block that is kept may be reused. False: there is none.
  bool cut_quarantine();

  bool make_writable(const posix::WriteFault& fault) noexcept override;

 private:
  enum State : std::uint32_t { opened, published, free, being_replaced, replaced };

  struct Guarded {
    std::atomic<std::uint32_t> state;
    std::uint64_t number;
    std::uint64_t offset;
    std::size_t bytes;
    guard::CallStack since;
  };
  struct Free {
    void operator()(void* memory) const { std::free(memory); }
  };

  SegmentGuard(const SegmentFile& file, const std::string& topic, Reuse reuse);
  void start_watching(Guarded& guarded, const Block& block) noexcept;
  void keep(Block& block);
  Guarded* find(const std::uint8_t* address) const noexcept;
  void protect(const Guarded& block, int protection) const noexcept;
  bool replace(Guarded& block, State was, const posix::WriteFault& fault) noexcept;

  const SegmentFile& file_;
  const std::string topic_;
  const std::size_t page_;
  std::unique_ptr<Guarded[], Free> blocks_;  // by slot
  std::unique_ptr<std::atomic<std::uint32_t>[], Free>
      pages_;  // where a block begins: its slot + 1, otherwise 0
  std::mutex publish_mutex_;
  std::uint64_t published_ = 0;
  std::deque<Block*> quarantine_;
  const Reuse reuse_;
};

}  // namespace segment
}  // namespace tzc
