// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "channel/wire.h"
#include "posix/hot.h"
#include "tzc/channel.h"

namespace tzc {
namespace channel {

/// The body as it goes over every socket, and the handles that keep its blocks alive meanwhile. A body of the
/// usual size lies in the record itself: one allocation for each message, and few cache lines.
class Record {
 public:
  TZC_HOT Record(const BodyHeader& header, const void* control, std::vector<BufferPtr> buffers);

  const std::uint8_t* data() const { return large_ ? large_.get() : small_; }
  std::size_t size() const { return size_; }
  const std::vector<BufferPtr>& buffers() const { return buffers_; }

 private:
  static constexpr std::size_t usual_bytes = 512;

  TZC_HOT std::uint8_t* append(std::uint8_t* at, const void* data, std::size_t size);

  const std::vector<BufferPtr> buffers_;
  const std::size_t size_;
  std::unique_ptr<std::uint8_t[]> large_;
  std::uint8_t small_[usual_bytes];  // not initialised: most of it is never looked at
};

}  // namespace channel
}  // namespace tzc
