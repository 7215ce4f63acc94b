// SPDX-License-Identifier: BSD-3-Clause
#include "segment/own_views.h"

#include <utility>

#include "segment/size_class.h"

namespace tzc {
namespace segment {

OwnViews::~OwnViews() {
  if (!views_) return;
  forget_at_forks(*this);
  registry().remove(views_->data());
}

const std::uint8_t* OwnViews::begin(const Block& block) {
  if (!has_own_pages(block.size(), posix::page_size()) || !open()) return nullptr;
  posix::keep_watching_write_faults();
  return views_->begin(block.offset, block.size()) ? views_->data() + block.offset : nullptr;
}

void OwnViews::end(const Block& block) {
  views_->end(block.offset, block.size());
}

bool OwnViews::offset_of(const std::uint8_t* address, std::uint64_t& offset) const {
  const std::uint8_t* const base = base_.load(std::memory_order_acquire);
  if (base == nullptr || address < base || address >= base + file_.size()) return false;
  offset = static_cast<std::uint64_t>(address - base);
  return true;
}

bool OwnViews::is_written(std::uint64_t offset) const {
  return views_->is_written(offset);
}

bool OwnViews::open() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (views_) return true;
  if (!can_make_private_pages()) return false;
  const SegmentPages& pages = file_.pages();
  auto mapping = posix::Mapping::map(pages.fd(), file_.size(), posix::Access::read_private, pages.offset());
  if (!mapping) return false;
  auto views = PrivateViews::create(std::move(*mapping), nullptr);
  if (!views) return false;
  views_ = std::move(*views);
  base_.store(views_->data(), std::memory_order_release);
  registry().add(MappedRange{views_->data(), views_->data() + file_.size(), &owner_});
  copy_at_forks(*this);
  return true;
}

}  // namespace segment
}  // namespace tzc
