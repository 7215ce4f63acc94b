// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "tzc/channel.h"

namespace tzc {
namespace channel {

/// The body as it goes over every socket, and the handles that keep its blocks alive meanwhile.
class Record {
 public:
  Record(std::vector<std::uint8_t> body, std::vector<BufferPtr> buffers)
      : body_(std::move(body)), buffers_(std::move(buffers)) {}

  const std::vector<std::uint8_t>& body() const { return body_; }
  const std::vector<BufferPtr>& buffers() const { return buffers_; }

 private:
  const std::vector<std::uint8_t> body_;
  const std::vector<BufferPtr> buffers_;
};

}  // namespace channel
}  // namespace tzc
