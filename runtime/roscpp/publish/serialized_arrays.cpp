// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/publish/serialized_arrays.h"

#include <new>

namespace tzc {
namespace detail {

// Behind a message with few arrays the next ones hardly have more: one of 2, 4, 8... is looked at.
bool SerializedArrays::encode(const MessageCodec& codec, const std::uint8_t* bytes, std::size_t size,
                              const std::shared_ptr<MemorySource>& memory, message::Encoded& encoded) {
  const std::uint32_t misses = misses_;
  if ((misses & (misses - 1)) != 0) {
    ++misses_;
    return false;
  }
  try {
    if (!codec.encode_serialized(bytes, size, memory, encoded)) return false;
  } catch (const std::bad_alloc&) {
    return false;  // the bytes may find room
  }
  const bool pays = encoded.copied_bytes >= size / 2;
  misses_ = pays ? 0 : misses + 1;
  return pays;
}

}  // namespace detail
}  // namespace tzc
