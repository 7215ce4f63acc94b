// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstdint>

#include "segment/layout.h"

namespace tzc {
namespace segment {

/// The parts of a mapped ack file. `slot` and `leaf` are in range: the file is as large as its slots need.
class AckView {
 public:
  AckView() = default;
  AckView(std::uint8_t* file, std::uint32_t slots) : file_(file), slots_(slots) {}

  std::uint32_t slots() const { return slots_; }
  std::atomic<std::uint64_t>& released() const { return reinterpret_cast<AckHeader*>(file_)->released; }
  std::atomic<std::uint64_t>& leaf(std::uint32_t leaf) const { return at(ack_header_bytes)[leaf]; }
  std::atomic<std::uint64_t>& word(std::uint32_t slot) const { return at(ack_words_offset(slots_))[slot]; }

 private:
  std::atomic<std::uint64_t>* at(std::size_t offset) const {
    return reinterpret_cast<std::atomic<std::uint64_t>*>(file_ + offset);
  }

  std::uint8_t* file_ = nullptr;
  std::uint32_t slots_ = 0;
};

}  // namespace segment
}  // namespace tzc
