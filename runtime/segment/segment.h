// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <string>

#include "segment/block.h"
#include "segment/extents.h"
#include "segment/holders.h"
#include "segment/live_blocks.h"
#include "segment/own_releases.h"
#include "segment/own_views.h"
#include "segment/registry.h"
#include "segment/segment_file.h"
#include "segment/segment_guard.h"
#include "segment/segment_ptr.h"
#include "tzc/memory.h"

namespace tzc {
namespace segment {

/// A part of this process's shared memory and the blocks in it.
///
/// allocate_block and free_if_unused are called by one allocator at a time (SegmentMemoryImpl's lock);
/// everything else is thread-safe. Counted by SegmentPtr and by each block that has a handle: it stays mapped
/// until the last one goes.
class Segment final : public OwnSegment {
 public:
  static Expected<SegmentPtr> create(std::size_t size, const MemoryOptions& options);

  enum class Where { touched_memory, anywhere };
  /// A block of exactly `bytes` whose handle() is counted, or null. Errors other than "no room" go to `failure`.
  Block* allocate_block(std::size_t bytes, Where where, Error& failure);
  /// Frees the block, unless a handle of this process or a subscriber may still read it.
  bool free_if_unused(Block& block);
  /// Null unless guard mode is on.
  SegmentGuard* guard() const { return guard_.get(); }
  Holders& holders() { return holders_; }
  /// The next block of which something was released since this was last asked; null: there is no more now. Nothing
  /// else can have become free. For the allocator alone.
  Block* next_released();
  /// A handle, a mark or a subscriber of the block in that slot is gone.
  void note_release(std::uint32_t slot) noexcept { releases_.add(slot); }

  FoundBuffer find(const std::uint8_t* address, std::size_t bytes) const override;
  OwnViews& own_views() { return own_views_; }
  void make_private() const noexcept override { file_.pages().make_private(); }
  /// A new handle of the block, although it may have none left. Only for a caller that has the block in flight:
  /// that keeps it from being reclaimed. Null: not that block any more.
  BufferPtr revive(std::uint64_t data_offset, const BlockName& name) const;
  static BlockName name_of(const Buffer& buffer);
  static Segment& of(const Buffer& buffer) { return *buffer.segment_; }

  const SegmentFile& file() const { return file_; }
  std::uint64_t id() const { return id_; }
  bool unused() const { return extents_.empty(); }
  /// The allocator let go of the segment: no new block will ever lie in it.
  void retire() { retired_.store(true, std::memory_order_release); }
  bool retired() const { return retired_.load(std::memory_order_acquire); }

  void add_user() noexcept { users_.fetch_add(1, std::memory_order_relaxed); }
  void drop_user() noexcept;

 private:
  friend class tzc::Buffer;
  Segment(SegmentFile file, const std::string& name);
  ~Segment();
  Segment(const Segment&) = delete;
  Segment& operator=(const Segment&) = delete;

  SegmentFile file_;
  std::unique_ptr<SegmentGuard> guard_;
  const std::uint64_t id_;
  const std::uint32_t epoch_;
  std::atomic<std::uint32_t> users_{0};
  std::atomic<bool> retired_{false};
  OwnReleases releases_;
  Extents extents_;
  LiveBlocks live_;
  OwnViews own_views_;
  Holders holders_;
};

}  // namespace segment
}  // namespace tzc
