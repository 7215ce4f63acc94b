// SPDX-License-Identifier: BSD-3-Clause
#include "channel/connect/loan_room.h"

#include <algorithm>

#include "posix/descriptor_use.h"

namespace tzc {
namespace channel {
namespace {

constexpr std::size_t share = 128;
constexpr std::size_t least = 8;

}  // namespace

std::size_t LoanRoom::share_of_process() {
  return std::max(posix::descriptor_limit() / share, least);
}

std::shared_ptr<LoanRoom::Taken> LoanRoom::take(std::uint64_t key) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (open_ < most()) {
    ++open_;
    return std::make_shared<Taken>(*this);
  }
  if (std::find(waiting_.begin(), waiting_.end(), key) == waiting_.end()) waiting_.push_back(key);
  return nullptr;
}

bool LoanRoom::is_scarce() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return open_ * 2 >= most();
}

bool LoanRoom::is_wanted() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return !waiting_.empty();
}

// All who wait look again: one of them alone might be gone, or have nothing to send any more.
void LoanRoom::give_back() {
  std::vector<std::uint64_t> waiting;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    --open_;
    waiting.swap(waiting_);
  }
  Service::Clock::time_point when = Service::Clock::now();
  for (const std::uint64_t key : waiting) service_.set_deadline(key, when += std::chrono::nanoseconds(1));
}

}  // namespace channel
}  // namespace tzc
