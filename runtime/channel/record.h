// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "segment/block.h"
#include "segment/segment_ptr.h"
#include "tzc/channel.h"

namespace tzc {
namespace channel {

/// The body as it goes over every socket, and the handles that keep its blocks alive meanwhile.
class Record {
 public:
  Record(std::vector<std::uint8_t> body, std::vector<BufferPtr> buffers);

  const std::vector<std::uint8_t>& body() const { return body_; }
  const std::vector<BufferPtr>& buffers() const { return buffers_; }
  /// The blocks' names, in the order of buffers().
  const std::vector<segment::BlockName>& names() const { return names_; }

 private:
  const std::vector<std::uint8_t> body_;
  const std::vector<BufferPtr> buffers_;
  std::vector<segment::BlockName> names_;
};

}  // namespace channel
}  // namespace tzc
