// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

#include "tzc/error.h"

namespace tzc {
namespace posix {

/// Private memory that is zero at first. From a page on, only pages that were written to take memory.
class ZeroedMemory {
 public:
  static Expected<ZeroedMemory> create(std::size_t bytes);

  /// Aligned for every type.
  std::uint8_t* data() const noexcept { return data_.get(); }

 private:
  struct Release {
    std::size_t mapped;  // 0: it is from the heap
    void operator()(std::uint8_t* data) const noexcept;
  };
  std::unique_ptr<std::uint8_t, Release> data_;
};

}  // namespace posix
}  // namespace tzc
