// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/hold_limit.h"

#include <utility>

namespace tzc {
namespace detail {

constexpr std::size_t HoldLimit::kFewMessages;
constexpr std::uint64_t HoldLimit::kDefaultBytes;

std::shared_ptr<const void> HoldLimit::hold(std::uint64_t bytes, std::shared_ptr<const void> kept) const {
  held_->bytes += bytes;
  ++held_->messages;
  const auto release = [held = held_, bytes, kept = std::move(kept)](const void*) mutable {
    held->bytes -= bytes;
    --held->messages;
    kept.reset();
  };
  return std::shared_ptr<const void>(held_.get(), release);
}

}  // namespace detail
}  // namespace tzc
