// SPDX-License-Identifier: BSD-3-Clause
#include "segment/segment_guard.h"

#include <sys/mman.h>

#include <utility>

namespace tzc {
namespace segment {
namespace {

template <class T>
T* zeroed(std::size_t count) {
  return static_cast<T*>(std::calloc(count, sizeof(T)));
}

}  // namespace

std::unique_ptr<SegmentGuard> SegmentGuard::create(const SegmentFile& file, const std::string& topic,
                                                   Reuse reuse) {
  guard::prepare_reports();
  std::unique_ptr<SegmentGuard> guard(new SegmentGuard(file, topic, std::move(reuse)));
  const bool usable =
      guard->blocks_ && guard->pages_ && posix::watch_write_faults(file.data(), file.size(), *guard);
  return usable ? std::move(guard) : nullptr;
}

SegmentGuard::SegmentGuard(const SegmentFile& file, const std::string& topic, Reuse reuse)
    : file_(file),
      topic_(topic.empty() ? "(unnamed)" : topic),
      page_(posix::page_size()),
      blocks_(zeroed<Guarded>(file.slots())),
      pages_(zeroed<std::atomic<std::uint32_t>>(file.size() / page_)),
      reuse_(std::move(reuse)) {}

SegmentGuard::~SegmentGuard() {
  posix::forget_write_faults(file_.data());
}

void SegmentGuard::protect(const Guarded& block, int protection) const noexcept {
  ::mprotect(file_.data() + block.offset, block.bytes, protection);
}

void SegmentGuard::start_watching(Guarded& guarded, const Block& block) noexcept {
  guarded.offset = block.offset;
  guarded.bytes = block.size();
  guarded.number = 0;
  guarded.since.size = 0;
  pages_[block.offset / page_].store(block.slot() + 1, std::memory_order_release);
}

// A message that is viewed first and sent afterwards is published twice; the later time says more.
void SegmentGuard::publish(const Block& block) noexcept {
  const std::lock_guard<std::mutex> lock(publish_mutex_);
  Guarded& guarded = blocks_[block.slot()];
  const std::uint32_t state = guarded.state.load(std::memory_order_acquire);
  if (state != opened && state != published) return;
  if (state == opened) start_watching(guarded, block);
  guarded.number = guard::message_number(state == opened ? ++published_ : guarded.number);
  guarded.since.capture();
  if (state == published) return;
  guard::count_published();
  posix::keep_watching_write_faults();
  guarded.state.store(published, std::memory_order_release);
  protect(guarded, PROT_READ);
}

void SegmentGuard::put_away(Block& block) {
  keep(block);
  while (quarantine_.size() > guard::quarantined_blocks()) cut_quarantine();
}

// A block that was written late is forgotten.
void SegmentGuard::keep(Block& block) {
  Guarded& guarded = blocks_[block.slot()];
  std::uint32_t state = guarded.state.load(std::memory_order_acquire);
  if (state == opened) start_watching(guarded, block);
  const bool is_clean = state == opened || state == published;
  if (!is_clean || !guarded.state.compare_exchange_strong(state, free, std::memory_order_acq_rel)) return;
  protect(guarded, PROT_NONE);
  quarantine_.push_back(&block);
}

bool SegmentGuard::cut_quarantine() {
  if (quarantine_.empty()) return false;
  Block& block = *quarantine_.front();
  quarantine_.pop_front();
  Guarded& guarded = blocks_[block.slot()];
  std::uint32_t was = free;
  if (!guarded.state.compare_exchange_strong(was, opened, std::memory_order_acq_rel)) return true;
  protect(guarded,
          PROT_READ | PROT_WRITE);  // before the block is found no more: another thread's fault tries again
  pages_[block.offset / page_].store(0, std::memory_order_release);
  reuse_(block);
  return true;
}

SegmentGuard::Guarded* SegmentGuard::find(const std::uint8_t* address) const noexcept {
  const auto offset = static_cast<std::uint64_t>(address - file_.data());
  for (std::size_t page = offset / page_ + 1; page-- > 0;) {
    const std::uint32_t slot = pages_[page].load(std::memory_order_acquire);
    if (slot == 0) continue;
    Guarded& block = blocks_[slot - 1];
    return offset - block.offset < block.bytes ? &block : nullptr;
  }
  return nullptr;
}

bool SegmentGuard::make_writable(const posix::WriteFault& fault) noexcept {
  Guarded* const block = find(fault.address);
  if (block == nullptr) return false;
  for (;;) {
    std::uint32_t state = block->state.load(std::memory_order_acquire);
    if (state == opened || state == replaced) return true;  // another thread was faster
    if (state == being_replaced) continue;
    if (block->state.compare_exchange_strong(state, being_replaced))
      return replace(*block, State(state), fault);
  }
}

// In a signal handler. The kernel puts the new mapping in the place of the old one in one step, so no other thread finds a
// hole there, and none can write to the file.
bool SegmentGuard::replace(Guarded& block, State was, const posix::WriteFault& fault) noexcept {
  std::uint8_t* const begin = file_.data() + block.offset;
  const auto kind = was == published ? guard::Stale::Kind::published : guard::Stale::Kind::free;
  guard::report({kind, topic_.c_str(), block.number, begin, block.bytes, &block.since}, fault);
  void* const mapped =
      ::mmap(begin, block.bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_FIXED | MAP_NORESERVE,
             file_.pages().fd(), static_cast<off_t>(file_.pages().offset() + block.offset));
  block.state.store(replaced, std::memory_order_release);
  return mapped != MAP_FAILED;
}

}  // namespace segment
}  // namespace tzc
