// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/subscribe/hold_limit.h"

#include <utility>

namespace tzc {
namespace detail {

constexpr std::size_t HoldLimit::kFewMessages;
constexpr std::uint64_t HoldLimit::kDefaultBytes;

std::uint64_t HoldLimit::size_of(const channel::Message& message) {
  std::uint64_t size = 0;
  for (const ConstBlock& block : message.blocks()) size += block.size;
  return size;
}

std::shared_ptr<const void> HoldLimit::hold(const channel::MessagePtr& message) const {
  const std::uint64_t size = size_of(*message);
  held_->bytes += size;
  ++held_->messages;
  const auto release = [held = held_, size, kept = message](const void*) mutable {
    held->bytes -= size;
    --held->messages;
    kept.reset();
  };
  return std::shared_ptr<const void>(message.get(), release);
}

}  // namespace detail
}  // namespace tzc
