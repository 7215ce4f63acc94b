// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/publish/sequence_numbers.h"

#include <algorithm>
#include <iterator>

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
  const auto found = std::find(waiting_.begin(), waiting_.end(), bytes);
  if (!is_queued(bytes) || found == waiting_.end()) return 0;
  const auto skipped = std::count(waiting_.begin(), found, kNumberedAlready);
  waiting_.erase(waiting_.begin(), std::next(found));  // those before it never came into the queue
  return static_cast<std::size_t>(skipped) + skip_numbered();
}

void SequenceNumbers::follow(const std::vector<const void*>& queue) {
  std::list<const void*> all;
  auto known = waiting_.begin();
  for (const void* bytes : queue) {
    if (const auto at = std::find(known, waiting_.end(), bytes); at != waiting_.end()) {
      std::copy_if(known, at, std::back_inserter(all), [](const void* each) { return !is_queued(each); });
      known = std::next(at);
    }
    all.push_back(bytes);
  }
  all.insert(all.end(), known, waiting_.end());
  waiting_.swap(all);  // as a whole: without memory it stays as it was
}

std::size_t SequenceNumbers::forget() {
  waiting_.remove_if(is_queued);
  return skip_numbered();
}

std::size_t SequenceNumbers::skip_numbered() {
  std::size_t skipped = 0;
  for (; !waiting_.empty() && waiting_.front() == kNumberedAlready; waiting_.pop_front()) ++skipped;
  return skipped;
}

}  // namespace detail
}  // namespace tzc
