// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <shared_mutex>
#include <vector>

#include "tzc/memory.h"

namespace tzc {
namespace segment {

/// One of this process's own segments. Thread-safe.
class OwnSegment {
 public:
  /// The live block that has the bytes; null when there is none, or it has no handle.
  virtual FoundBuffer find(const std::uint8_t* address, std::size_t bytes) const = 0;
  /// In a forked child: the memory is its own from now on.
  virtual void make_private() const noexcept = 0;

 protected:
  ~OwnSegment() = default;
};

struct MappedRange {
  const std::uint8_t* begin;
  const std::uint8_t* end;
  const OwnSegment* own;  // null: received from a publisher
};

/// Every segment mapped in this process, by address: what makes find_buffer possible. One for each process,
/// because an address space is. Thread-safe.
class Registry {
 public:
  void add(const MappedRange& range);
  void remove(const std::uint8_t* begin);
  bool contains(const std::uint8_t* address) const;
  FoundBuffer find(const std::uint8_t* address, std::size_t bytes) const;

  /// Around a fork: locked before, unlocked by the parent, renewed in the child, which gets memory of its own.
  void lock() { mutex_.lock(); }
  void unlock() { mutex_.unlock(); }
  void renew_in_child();

 private:
  const MappedRange* range_of(const std::uint8_t* address) const;

  mutable std::shared_mutex mutex_;
  std::vector<MappedRange> ranges_;  // sorted by address
};

/// Never destroyed: messages may outlive static destruction.
Registry& registry();

}  // namespace segment
}  // namespace tzc
