// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/publish/sequence_numbers.h"

#include <algorithm>

namespace tzc {
namespace detail {
namespace {

constexpr const void* kNumberedAlready = nullptr;

bool is_queued(const void* message) {
  return message != kNumberedAlready;
}

}  // namespace

SequenceNumbers::Taken SequenceNumbers::take(const void* queued, std::uint32_t count) {
  const std::uint32_t number = next(count);
  const bool counts_now = !queued && waiting_.empty();
  if (!counts_now) waiting_.push_back(queued ? queued : kNumberedAlready);
  return Taken{number, counts_now};
}

std::size_t SequenceNumbers::queued() const {
  return static_cast<std::size_t>(std::count_if(waiting_.begin(), waiting_.end(), is_queued));
}

std::size_t SequenceNumbers::numbered(const void* bytes) {
  if (waiting_.empty() || waiting_.front() != bytes) return 0;
  waiting_.pop_front();
  return skip_numbered();
}

void SequenceNumbers::follow(const std::vector<const void*>& queue) {
  for (std::size_t i = queued(); i < queue.size(); ++i) waiting_.push_back(queue[i]);
}

std::size_t SequenceNumbers::forget() {
  waiting_.erase(std::remove_if(waiting_.begin(), waiting_.end(), is_queued), waiting_.end());
  return skip_numbered();
}

std::size_t SequenceNumbers::skip_numbered() {
  std::size_t skipped = 0;
  for (; !waiting_.empty() && waiting_.front() == kNumberedAlready; waiting_.pop_front()) ++skipped;
  return skipped;
}

}  // namespace detail
}  // namespace tzc
