// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tzc/detail/codec.h>
#include <tzc/memory.h>
#include <tzc/message.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>

namespace tzc {
namespace detail {

/// Puts the arrays of one topic's serialized messages into shared memory, where that pays (decision 510). Thread-safe.
class SerializedArrays {
 public:
  /// False: the bytes are to be sent as they are, because they are no message of the codec's, or mostly no arrays, or lack memory.
  bool encode(const MessageCodec& codec, const std::uint8_t* bytes, std::size_t size,
              const std::shared_ptr<MemorySource>& memory, message::Encoded& encoded);

 private:
  std::atomic<std::uint32_t> misses_{0};  ///< messages since the last one with which it paid
};

}  // namespace detail
}  // namespace tzc
