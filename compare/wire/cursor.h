// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <vector>

namespace tzc::compare {

using Bytes = std::vector<std::uint8_t>;

/// A place in a message's bytes. Nothing is read beyond their end: the bytes may be damaged.
class Cursor {
 public:
  explicit Cursor(const Bytes& bytes) : bytes_(&bytes) {}

  std::size_t offset() const { return offset_; }
  std::size_t left() const { return bytes_->size() - offset_; }
  const std::uint8_t* data() const { return bytes_->data() + offset_; }

  bool skip(std::size_t count) {
    if (count > left()) return false;
    offset_ += count;
    return true;
  }
  bool skip(std::size_t count, std::size_t size) {
    return size == 0 || (count <= left() / size && skip(count * size));
  }

  std::optional<std::uint32_t> read_uint32() {
    std::uint32_t value = 0;
    if (left() < sizeof value) return std::nullopt;
    std::memcpy(&value, data(), sizeof value);
    offset_ += sizeof value;
    return value;
  }

 private:
  const Bytes* bytes_;
  std::size_t offset_ = 0;
};

}  // namespace tzc::compare
