// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "posix/mapping.h"
#include "posix/memory_file.h"
#include "segment/block.h"
#include "segment/extents.h"
#include "segment/ledger.h"
#include "segment/segment_ptr.h"
#include "tzc/memory.h"

namespace tzc {
namespace segment {

/// Someone who can take back what is in flight to a subscriber: the channel's connections.
class Revoker {
 public:
  virtual ~Revoker() = default;
  /// Revokes every record that refers to the block and was not taken yet, and those sent before it.
  virtual void give_up(const BlockName& block) = 0;
};

/// One memory file of this process and the blocks in it.
///
/// carve and give_back are called by one allocator at a time (SegmentMemoryImpl's lock); everything else is
/// thread-safe. Counted by SegmentPtr and by each block that has a handle: it stays mapped until the last one
/// goes.
class Segment {
 public:
  static Expected<SegmentPtr> create(std::size_t size, const std::string& name, Prefault prefault);

  enum class Where { touched_memory, anywhere };
  /// A block of exactly `bytes` with one handle, or null. Errors other than "no room" go to `failure`.
  Block* carve(std::size_t bytes, Where where, Error& failure);
  void give_back(Block& block);
  static BufferPtr handle(Block& block) { return BufferPtr(&block, BufferPtr::Adopt{}); }

  /// Somebody may still read the block: a handle of this process, or a subscriber.
  bool in_use(const Block& block) const;
  bool has_handles(const Block& block) const;
  bool taken_by_subscriber(const Block& block) const;
  /// Asks every connection that may have the block in flight to give it up.
  void revoke(const Block& block);

  void attach(const std::shared_ptr<Ledger>& ledger, const std::weak_ptr<Revoker>& revoker);
  void detach(const std::shared_ptr<Ledger>& ledger);
  /// Whether a handle, a subscriber or the end of one released anything here since this was last asked. For
  /// the allocator alone.
  bool notice_releases();

  /// The live block that contains the bytes.
  BufferPtr find(const std::uint8_t* address, std::size_t bytes) const;
  /// A new handle of the block, although it may have none left. Only for whoever has the block in flight:
  /// that keeps it from being reclaimed. Null: not that block any more.
  BufferPtr revive(std::uint64_t data_offset, const BlockName& name) const;
  static BlockName name_of(const Buffer& buffer);
  static Segment& of(const Buffer& buffer) { return *buffer.segment_; }

  std::uint64_t id() const { return id_; }
  std::uint32_t slots() const { return max_slots_; }
  std::size_t size() const { return mapping_.size(); }
  std::size_t reserved_bytes() const { return reserved_; }
  std::uint8_t* data() const { return mapping_.data(); }
  int fd() const { return file_.shared_fd(); }
  bool unused() const { return extents_.empty(); }
  /// The allocator let go of the segment: no new block will ever lie in it.
  void retire() { retired_.store(true, std::memory_order_release); }
  bool retired() const { return retired_.load(std::memory_order_acquire); }

  void add_user() noexcept { users_.fetch_add(1, std::memory_order_relaxed); }
  void drop_user() noexcept;
  void count_release() noexcept { releases_.fetch_add(1, std::memory_order_release); }

 private:
  struct Attachment {
    std::shared_ptr<Ledger> ledger;
    std::weak_ptr<Revoker> revoker;
    std::uint64_t noticed_releases;
  };

  Segment(posix::MemoryFile file, posix::Mapping mapping, const std::string& name, Prefault prefault);
  ~Segment();
  Segment(const Segment&) = delete;
  Segment& operator=(const Segment&) = delete;

  Block* free_slot();
  bool commit(std::uint64_t end, Error& failure);
  void open_block(Block& block, std::uint64_t offset, std::uint64_t extent);

  posix::MemoryFile file_;
  posix::Mapping mapping_;
  const std::uint64_t id_;
  const std::uint32_t max_slots_;
  const Prefault prefault_;
  const std::uint32_t epoch_;
  std::atomic<std::uint32_t> users_{0};
  std::atomic<std::uint64_t> releases_{0};  // by handles, and by ledgers that are gone
  std::uint64_t noticed_releases_ = ~std::uint64_t{0};
  std::atomic<bool> retired_{false};

  Extents extents_;
  std::size_t reserved_;     // everything below is committed
  std::deque<Block> slots_;  // a deque: blocks never move
  std::vector<Block*> spare_slots_;

  mutable std::mutex live_mutex_;  // guards live_ between the allocator and find
  std::map<std::uint64_t, Block*> live_;
  std::vector<std::map<std::uint64_t, Block*>::node_type> spare_nodes_;

  mutable std::mutex attachments_mutex_;
  std::vector<Attachment> attachments_;
};

}  // namespace segment
}  // namespace tzc
