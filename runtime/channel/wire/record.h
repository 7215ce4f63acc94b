// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "channel/wire/small_vector.h"
#include "channel/wire/wire.h"
#include "posix/hot.h"
#include "tzc/channel.h"

namespace tzc {
namespace channel {

/// The body of a record as every socket carries it, and handles of its blocks. A body of the usual size lies
/// in the record itself: one allocation for each message, and few cache lines.
class Record {
 public:
  /// `control_block` holds the control part, as the header states, and is the last block; otherwise it is
  /// null.
  TZC_HOT Record(const BodyHeader& header, const void* control, BufferSpan buffers,
                 const BufferPtr& control_block = nullptr);

  const std::uint8_t* data() const { return large_ ? large_.get() : small_; }
  std::size_t size() const { return size_; }
  const SmallVector<BufferPtr, 2>& buffers() const { return buffers_; }

  /// Up to this size data() lies in the record itself.
  static constexpr std::size_t usual_bytes = 512;

 private:
  SmallVector<BufferPtr, 2> buffers_;
  std::size_t size_;
  std::unique_ptr<std::uint8_t[]> large_;
  std::uint8_t small_[usual_bytes];  // not initialised: most of it is never looked at
};

}  // namespace channel
}  // namespace tzc
