// SPDX-License-Identifier: BSD-3-Clause
#include "segment/holders.h"

#include <algorithm>

namespace tzc {
namespace segment {

void Holders::attach(const std::shared_ptr<AckFile>& ack_file, const std::weak_ptr<Revoker>& revoker) {
  const std::lock_guard<std::mutex> lock(mutex_);
  holders_.push_back(Holder{ack_file, revoker});
}

void Holders::detach(const std::shared_ptr<AckFile>& ack_file) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto gone = std::remove_if(holders_.begin(), holders_.end(),
                                   [&ack_file](const Holder& holder) { return holder.ack_file == ack_file; });
  holders_.erase(gone, holders_.end());
}

bool Holders::hold(const BlockName& block) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return std::any_of(holders_.begin(), holders_.end(), [&block](const Holder& holder) {
    return holder.ack_file->holds(block.slot, block.generation);
  });
}

bool Holders::have_taken(const BlockName& block) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return std::any_of(holders_.begin(), holders_.end(), [&block](const Holder& holder) {
    return holder.ack_file->taken(block.slot, block.generation);
  });
}

void Holders::revoke(const BlockName& block) const {
  for (const auto& revoker : revokers()) revoker->revoke(block);
}

void Holders::revoke_buffered() const {
  for (const auto& revoker : revokers()) revoker->revoke_buffered();
}

std::size_t Holders::waiting_handles(const BlockName& block) const {
  std::vector<const void*> handles;
  for (const auto& revoker : revokers()) revoker->add_waiting(block, handles);
  std::sort(handles.begin(), handles.end());
  return static_cast<std::size_t>(std::unique(handles.begin(), handles.end()) - handles.begin());
}

// Copied: a connection locks itself to revoke, and one that sends takes mutex_ while it is locked.
std::vector<std::shared_ptr<Revoker>> Holders::revokers() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  std::vector<std::shared_ptr<Revoker>> alive;
  for (const Holder& holder : holders_) {
    if (auto revoker = holder.revoker.lock()) alive.push_back(std::move(revoker));
  }
  return alive;
}

std::uint32_t Holders::next_released() {
  const std::lock_guard<std::mutex> lock(mutex_);
  for (std::size_t i = 0; i < holders_.size(); ++i) {
    next_ = next_ + 1 < holders_.size() ? next_ + 1 : 0;
    const std::uint32_t slot = holders_[next_].ack_file->next_released();
    if (slot != no_slot) return slot;
  }
  return no_slot;
}

std::size_t Holders::count() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return holders_.size();
}

}  // namespace segment
}  // namespace tzc
