// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>

#include "tzc/error.h"

namespace tzc {
namespace posix {

enum class Access {
  read_only,
  read_write,
  read_private,  ///< read-only; a page that is made writable later is copied
};

/// A mapping of a memory file, or of a part of one; unmapped with its owner. Commits no pages by itself.
class Mapping {
 public:
  Mapping() noexcept = default;
  Mapping(Mapping&& other) noexcept
      : data_(std::exchange(other.data_, nullptr)), size_(std::exchange(other.size_, 0)) {}
  Mapping& operator=(Mapping&& other) noexcept {
    std::swap(data_, other.data_);
    std::swap(size_, other.size_);
    return *this;
  }
  ~Mapping();

  /// The part begins at `offset`, a multiple of the page size.
  static Expected<Mapping> map(int fd, std::size_t size, Access access, std::uint64_t offset = 0);

  /// In a forked child: its writes stay its own from now on, and it sees what the parent writes until then, as
  /// everywhere else. `fd` and `offset` are those of map(). Not once more in a child of that child, who would lose what was
  /// written. False: the system refuses it. Async-signal-safe.
  bool make_private(int fd, std::uint64_t offset = 0) const noexcept;

  std::uint8_t* data() const noexcept { return data_; }
  std::size_t size() const noexcept { return size_; }
  /// Touches the pages of [offset, offset + bytes) for writing, so that no later write faults. They must be
  /// reserved.
  void populate(std::size_t offset, std::size_t bytes) const noexcept;

 private:
  std::uint8_t* data_ = nullptr;
  std::size_t size_ = 0;
};

std::size_t page_size() noexcept;

}  // namespace posix
}  // namespace tzc
