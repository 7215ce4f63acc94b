// SPDX-License-Identifier: BSD-3-Clause
#include "segment/segment.h"

#include <algorithm>
#include <cstring>
#include <new>

#include "posix/fork_epoch.h"
#include "posix/step.h"
#include "segment/ack_word.h"
#include "segment/layout.h"
#include "segment/registry.h"

namespace tzc {
namespace segment {
namespace {

// Ids and generations start shortly before they wrap around, so that every run exercises it.
constexpr std::uint32_t first_generation = 0xffffffff - 2;

std::uint64_t next_segment_id() {
  static std::atomic<std::uint64_t> next{1};
  return next.fetch_add(1, std::memory_order_relaxed);
}

// A slot for each page of small blocks; fewer than 64 would limit small segments, more than 65536 buys
// nothing.
std::uint32_t slots_for(std::size_t size) {
  return static_cast<std::uint32_t>(std::clamp<std::size_t>(size / 4096, 64, 65536));
}

std::size_t round_up(std::size_t bytes, std::size_t unit) {
  return (bytes + unit - 1) / unit * unit;
}

// Room for the headers comes on top: N messages of S bytes fit into a memory of N * S, down to S = 4096.
std::size_t file_size_for(std::size_t payload) {
  return round_up(payload + payload / 4096 * block_header_bytes + segment_header_bytes + block_header_bytes,
                  posix::page_size());
}

}  // namespace

Expected<SegmentPtr> Segment::create(std::size_t size, const std::string& name, Prefault prefault) {
  const auto sharing = posix::Sharing::peers_read;
  auto file = posix::create_memory_file("tzc-segment", file_size_for(size), sharing);
  if (!file) return file.error();
  auto mapping = posix::Mapping::map(file->descriptor.get(), file->size, posix::Access::read_write);
  if (!mapping) return mapping.error();
  const Status sealed = posix::seal(*file, sharing);
  if (!sealed) return sealed.error();
  const std::size_t committed = prefault == Prefault::all ? file->size : posix::page_size();
  const Status reserved = posix::reserve(*file, 0, committed);
  if (!reserved) return reserved.error();
  if (prefault == Prefault::all) mapping->populate(0, committed);
  SegmentPtr segment(new Segment(std::move(*file), std::move(*mapping), name, prefault));
  segment->reserved_ = committed;
  return segment;
}

Segment::Segment(posix::MemoryFile file, posix::Mapping mapping, const std::string& name, Prefault prefault)
    : file_(std::move(file)),
      mapping_(std::move(mapping)),
      id_(next_segment_id()),
      max_slots_(slots_for(mapping_.size())),
      prefault_(prefault),
      epoch_(posix::fork_epoch()),
      extents_(segment_header_bytes, mapping_.size() / cache_line * cache_line),
      reserved_(0) {
  auto* header =
      new (mapping_.data()) SegmentHeader{segment_magic, layout_version, max_slots_, id_, size(), {}};
  name.copy(header->name, sizeof header->name - 1);
  registry().add(MappedRange{mapping_.data(), mapping_.data() + mapping_.size(), this});
}

Segment::~Segment() {
  registry().remove(mapping_.data());
}

void Segment::drop_user() noexcept {
  if (users_.fetch_sub(1, std::memory_order_acq_rel) == 1) delete this;
}

Block* Segment::carve(std::size_t bytes, Where where, Error& failure) {
  const std::uint64_t extent = block_header_bytes + bytes;
  const std::uint64_t limit = where == Where::touched_memory ? reserved_ : Extents::none;
  Block* block = free_slot();
  if (block == nullptr) return nullptr;
  const std::uint64_t offset = extents_.allocate(extent, limit);
  if (offset == Extents::none || !commit(offset + extent, failure)) {
    if (offset != Extents::none) extents_.release(offset, extent);
    spare_slots_.push_back(block);
    return nullptr;
  }
  posix::step("allocate: carved");
  open_block(*block, offset, extent);
  return block;
}

Block* Segment::free_slot() {
  if (!spare_slots_.empty()) {
    Block* block = spare_slots_.back();
    spare_slots_.pop_back();
    return block;
  }
  if (slots_.size() == max_slots_) return nullptr;
  Block& block = slots_.emplace_back();
  block.slot_ = static_cast<std::uint32_t>(slots_.size() - 1);
  block.generation_ = first_generation;
  block.segment_ = this;
  return &block;
}

// Pages are reserved in order of address, so one mark tells which are.
bool Segment::commit(std::uint64_t end, Error& failure) {
  if (end <= reserved_) return true;
  const std::size_t target = std::min(round_up(end, posix::page_size()), size());
  const Status reserved = posix::reserve(file_, reserved_, target - reserved_);
  if (!reserved) {
    failure = reserved.error();
    return false;
  }
  if (prefault_ != Prefault::none) mapping_.populate(reserved_, target - reserved_);
  reserved_ = target;
  return true;
}

void Segment::open_block(Block& block, std::uint64_t offset, std::uint64_t extent) {
  block.generation_ = next_generation(block.generation_);
  block.offset = offset;
  block.extent = extent;
  block.data_ = mapping_.data() + offset + block_header_bytes;
  block.size_ = extent - block_header_bytes;
  block.sealed_.store(false, std::memory_order_relaxed);
  new (mapping_.data() + offset) BlockHeader{block_magic, block.generation_, block.slot_, 0, block.size_};
  add_user();
  block.references_.store(1, std::memory_order_release);
  const std::lock_guard<std::mutex> lock(live_mutex_);
  if (spare_nodes_.empty()) {
    live_.emplace(offset, &block);
    return;
  }
  auto node = std::move(spare_nodes_.back());
  spare_nodes_.pop_back();
  node.key() = offset;
  node.mapped() = &block;
  live_.insert(std::move(node));
}

void Segment::give_back(Block& block) {
  {
    const std::lock_guard<std::mutex> lock(live_mutex_);
    spare_nodes_.push_back(live_.extract(block.offset));
  }
  extents_.release(block.offset, block.extent);
  spare_slots_.push_back(&block);
}

bool Segment::has_handles(const Block& block) const {
  return block.references_.load(std::memory_order_acquire) != 0;
}

bool Segment::in_use(const Block& block) const {
  if (has_handles(block)) return true;
  const std::lock_guard<std::mutex> lock(attachments_mutex_);
  return std::any_of(attachments_.begin(), attachments_.end(), [&block](const Attachment& attachment) {
    return attachment.ledger->holds(block.slot_, block.generation_);
  });
}

bool Segment::taken_by_subscriber(const Block& block) const {
  const std::lock_guard<std::mutex> lock(attachments_mutex_);
  return std::any_of(attachments_.begin(), attachments_.end(), [&block](const Attachment& attachment) {
    return attachment.ledger->taken(block.slot_, block.generation_);
  });
}

// Copied first: a connection locks itself, and one that sends takes attachments_mutex_ while it is locked.
void Segment::revoke(const Block& block) {
  std::vector<std::weak_ptr<Revoker>> revokers;
  {
    const std::lock_guard<std::mutex> lock(attachments_mutex_);
    for (const Attachment& attachment : attachments_) revokers.push_back(attachment.revoker);
  }
  for (const auto& weak : revokers) {
    if (const auto revoker = weak.lock()) revoker->give_up(name_of(block));
  }
}

void Segment::attach(const std::shared_ptr<Ledger>& ledger, const std::weak_ptr<Revoker>& revoker) {
  const std::lock_guard<std::mutex> lock(attachments_mutex_);
  attachments_.push_back(Attachment{ledger, revoker, ledger->releases()});
}

void Segment::detach(const std::shared_ptr<Ledger>& ledger) {
  const std::lock_guard<std::mutex> lock(attachments_mutex_);
  const auto gone =
      std::remove_if(attachments_.begin(), attachments_.end(),
                     [&ledger](const Attachment& attachment) { return attachment.ledger == ledger; });
  attachments_.erase(gone, attachments_.end());
  count_release();
}

// Each count is compared with itself: a sum could come back to an earlier value, and a subscriber chooses its
// own.
bool Segment::notice_releases() {
  const std::uint64_t own = releases_.load(std::memory_order_acquire);
  bool noticed = own != noticed_releases_;
  noticed_releases_ = own;
  const std::lock_guard<std::mutex> lock(attachments_mutex_);
  for (Attachment& attachment : attachments_) {
    const std::uint64_t now = attachment.ledger->releases();
    noticed |= now != attachment.noticed_releases;
    attachment.noticed_releases = now;
  }
  return noticed;
}

BufferPtr Segment::find(const std::uint8_t* address, std::size_t bytes) const {
  if (posix::forked_since(epoch_)) return nullptr;  // the parent may reuse the block at any time
  const auto position = static_cast<std::uint64_t>(address - mapping_.data());
  const std::lock_guard<std::mutex> lock(live_mutex_);
  auto after = live_.upper_bound(position);
  if (after == live_.begin()) return nullptr;
  Block& block = *std::prev(after)->second;
  const std::uint64_t begin = block.offset + block_header_bytes;
  if (position < begin || position - begin > block.size_ || bytes > block.size_ - (position - begin))
    return nullptr;
  std::uint32_t handles = block.references_.load(std::memory_order_relaxed);
  while (handles != 0) {  // never revive a block that the allocator may be reclaiming
    if (block.references_.compare_exchange_weak(handles, handles + 1, std::memory_order_acquire))
      return handle(block);
  }
  return nullptr;
}

BufferPtr Segment::revive(std::uint64_t data_offset, const BlockName& name) const {
  if (posix::forked_since(epoch_)) return nullptr;
  const std::lock_guard<std::mutex> lock(live_mutex_);
  const auto found = live_.find(data_offset - block_header_bytes);
  if (found == live_.end()) return nullptr;
  Block& block = *found->second;
  if (block.slot_ != name.slot || block.generation_ != name.generation) return nullptr;
  if (block.references_.fetch_add(1, std::memory_order_acq_rel) == 0) block.segment_->add_user();
  return handle(block);
}

BlockName Segment::name_of(const Buffer& buffer) {
  return BlockName{buffer.segment_->id_, buffer.slot_, buffer.generation_};
}

}  // namespace segment
}  // namespace tzc
