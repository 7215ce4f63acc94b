// SPDX-License-Identifier: BSD-3-Clause
#include "segment/segment.h"

#include <algorithm>
#include <new>
#include <utility>

#include "posix/fork_epoch.h"
#include "segment/ack_word.h"
#include "segment/layout.h"
#include "segment/size_class.h"
#include "sync_point/sync_point.h"

namespace tzc {
namespace segment {
namespace {

std::uint64_t next_segment_id() {
  static std::atomic<std::uint64_t> next{1};
  return next.fetch_add(1, std::memory_order_relaxed);
}

}  // namespace

Expected<SegmentPtr> Segment::create(std::size_t size, const MemoryOptions& options) {
  auto file = SegmentFile::create(size, options.prefault, options.pooled);
  if (!file) return file.error();
  return SegmentPtr(new Segment(std::move(*file), options.name));
}

Segment::Segment(SegmentFile file, const std::string& name)
    : file_(std::move(file)),
      id_(next_segment_id()),
      epoch_(posix::fork_epoch()),
      releases_(file_.slots()),
      extents_(file_.payloads_begin(), file_.size()),
      live_(*this, file_.slots()),
      own_views_(file_, *this) {
  auto* header =
      new (file_.data()) SegmentHeader{segment_magic, layout_version, file_.slots(), id_, file_.size(), {}};
  name.copy(header->name, sizeof header->name - 1);
  registry().add(MappedRange{file_.data(), file_.data() + file_.size(), this});
  if (!guard::active) return;
  guard_ = SegmentGuard::create(file_, name, [this](Block& block) {
    extents_.release(block.offset, block.size());
    live_.return_slot(block);
  });
}

Segment::~Segment() {
  registry().remove(file_.data());
}

void Segment::drop_user() noexcept {
  if (users_.fetch_sub(1, std::memory_order_acq_rel) == 1) delete this;
}

Block* Segment::allocate_block(std::size_t bytes, Where where, Error& failure) {
  const std::size_t page = posix::page_size();
  const std::uint64_t alignment = has_own_pages(bytes, page) ? page : cache_line;
  const std::uint64_t limit = where == Where::touched_memory ? file_.payloads_committed() : Extents::none;
  Block* block = live_.take_slot();
  if (block == nullptr) return nullptr;
  const std::uint64_t offset = extents_.allocate(bytes, limit, alignment);
  const Status committed =
      offset == Extents::none ? Status(Success{}) : file_.commit(block->slot(), offset + bytes);
  if (!committed) failure = committed.error();
  if (offset == Extents::none || !committed) {
    if (offset != Extents::none) extents_.release(offset, bytes);
    live_.return_slot(*block);
    return nullptr;
  }
  sync_point("allocate: placed");
  block->offset = offset;
  block->extent = bytes;
  block->open(next_generation(block->generation()), file_.data() + offset, bytes);
  new (file_.data() + block_header_offset(block->slot()))
      BlockHeader{block_magic, block->generation(), block->slot(), 0, offset, bytes};
  add_user();
  live_.add(*block);
  return block;
}

bool Segment::free_if_unused(Block& block) {
  const auto held = [this, &block] {
    sync_point("allocate: no handles");
    return holders_.hold(name_of(block));
  };
  if (!live_.remove_if_unused(block, held)) return false;
  block.extent = 0;
  if (guard_) {
    guard_->put_away(block);
  } else {
    extents_.release(block.offset, block.size());
    live_.return_slot(block);
  }
  return true;
}

Block* Segment::next_released() {
  for (;;) {
    std::uint32_t slot = releases_.next();
    if (slot == no_slot) slot = holders_.next_released();
    if (slot == no_slot) return nullptr;
    Block* block = live_.at(slot);
    if (block != nullptr && block->extent != 0) return block;
  }
}

FoundBuffer Segment::find(const std::uint8_t* address, std::size_t bytes) const {
  if (posix::forked_since(epoch_)) return {};  // the parent may reuse the block at any time
  auto position = static_cast<std::uint64_t>(address - file_.data());
  const bool in_view = position >= file_.size();
  if (in_view && !own_views_.offset_of(address, position)) return {};
  Block* block = live_.find(position, bytes);
  if (block == nullptr) return {};
  const FoundBuffer found{block->handle(), static_cast<std::size_t>(position - block->offset)};
  return in_view && own_views_.is_written(block->offset) ? FoundBuffer() : found;
}

BufferPtr Segment::revive(std::uint64_t data_offset, const BlockName& name) const {
  if (posix::forked_since(epoch_)) return nullptr;
  bool first = false;
  Block* block = live_.revive(data_offset, name, first);
  if (block == nullptr) return nullptr;
  if (first) of(*block).add_user();
  return block->handle();
}

BlockName Segment::name_of(const Buffer& buffer) {
  return BlockName{buffer.segment_->id_, buffer.slot_, buffer.generation_};
}

}  // namespace segment
}  // namespace tzc
