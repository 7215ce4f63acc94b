// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>

namespace tzc {

class MemorySource;

/// Guard mode (docs/guard.md), the check that a ported publisher does not write to a message after it was published. Used by
/// TZC's own headers and libraries; a program turns it on with the environment variable TZC_GUARD. All of it is
/// thread-safe.
namespace guard {

/// Guard mode is on. Set when the library is loaded, and not changed afterwards.
extern bool active;

/// Memory in pages that it shares with nothing, to be freed as std::allocator frees. Null: take it from std::allocator.
void* allocate(std::size_t bytes) noexcept;
/// The elements of an array have moved from there into a block of `source`, so pointers that a program kept are stale. An
/// access through one is reported from now on. Takes over the memory, which std::allocator frees, or allocate() made.
void retire(void* memory, std::size_t bytes, const MemorySource* source) noexcept;
/// The elements there were sent as a copy in a block of `source`, so a write through a pointer that a program kept changes what
/// nobody sees. Such a write is reported until thaw(). The memory stays the caller's.
void freeze(void* memory, std::size_t bytes, const MemorySource* source) noexcept;
/// The memory may be written again. Does nothing for memory that was not frozen.
void thaw(const void* memory) noexcept;

/// While it lives, reports call what this thread publishes "message NUMBER".
class MessageNumber {
 public:
  explicit MessageNumber(std::uint64_t number) noexcept {
    if (active) set(number);
  }
  ~MessageNumber() {
    if (active) clear();
  }
  MessageNumber(const MessageNumber&) = delete;
  MessageNumber& operator=(const MessageNumber&) = delete;

 private:
  static void set(std::uint64_t number) noexcept;
  static void clear() noexcept;
};

}  // namespace guard
}  // namespace tzc
