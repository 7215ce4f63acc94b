// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>

namespace tzc {
namespace posix {

/// The most bytes that all memory files of this process may have reserved at a time; SIZE_MAX: no limit. Files that
/// are over a lower ceiling keep what they have. Thread-safe.
void set_memory_ceiling(std::size_t bytes) noexcept;
std::size_t memory_ceiling() noexcept;
/// What they have reserved now. Thread-safe.
std::size_t reserved_memory() noexcept;

/// What one memory file has reserved: counted in the process's total while it lives. Thread-safe but for moves.
class ReservedBytes {
 public:
  ReservedBytes() = default;
  ReservedBytes(ReservedBytes&& other) noexcept;
  ReservedBytes& operator=(ReservedBytes&& other) noexcept;
  ~ReservedBytes();

  /// False: the ceiling does not allow so many more; nothing is counted.
  bool add(std::size_t bytes) noexcept;
  void remove(std::size_t bytes) noexcept;

 private:
  std::atomic<std::size_t> bytes_{0};
};

/// A part of the headroom (memory_limit.h) that was read a moment ago, for commits of a few pages: to read it again for
/// each would mean to parse several files. Lock-free, because a forked child may find it in use.
class HeadroomAllowance {
 public:
  using Clock = std::chrono::steady_clock;
  static constexpr std::size_t most_bytes = std::size_t{16} << 20;
  static constexpr std::chrono::milliseconds lifetime{100};

  /// Takes the bytes from what was there; false: read again.
  bool take(std::size_t bytes, Clock::time_point now) noexcept;
  /// So much was there just now; the caller takes `bytes` of it.
  void refill(std::size_t headroom, std::size_t bytes, Clock::time_point now) noexcept;

 private:
  std::atomic<std::size_t> left_{0};
  std::atomic<Clock::rep> until_{0};
};

}  // namespace posix
}  // namespace tzc
