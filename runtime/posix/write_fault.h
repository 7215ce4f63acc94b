// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>

namespace tzc {
namespace posix {

/// An access to protected memory.
struct WriteFault {
  const std::uint8_t* address;
  const void* instruction;  ///< that made it; null where that is not known
};

/// Protected memory that may be made accessible when this process uses it nevertheless.
class WriteFaultArea {
 public:
  /// True: the access may be tried again. In a signal handler: async-signal-safe.
  virtual bool make_writable(const WriteFault& fault) noexcept = 0;

 protected:
  ~WriteFaultArea() = default;
};

/// From now on a fault in [begin, begin + size) asks `area`. Installs a handler of SIGSEGV (fault_handlers.h). False: too
/// many areas, or no handler could be installed. Thread-safe.
bool watch_write_faults(const std::uint8_t* begin, std::size_t size, WriteFaultArea& area);
/// No access is made there any more.
void forget_write_faults(const std::uint8_t* begin);
/// Looks whether other code has installed a handler since; ours is made the first again. Faults of the calling thread reach it from
/// now on, too, should the thread block their signals, and those that it starts. Two system calls; before anything is watched one, once
/// on each thread. Thread-safe.
void keep_watching_write_faults();

}  // namespace posix
}  // namespace tzc
