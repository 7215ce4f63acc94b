// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>

#include "posix/write_fault.h"

namespace tzc {
namespace guard {

/// Return addresses of calls, the latest first.
struct CallStack {
  static constexpr int most = 40;
  void* frames[most];
  int size;

  /// Of the caller. Async-signal-safe once prepare_reports has run.
  void capture() noexcept;
};

/// Memory that must not be used any more, for a report.
struct Stale {
  enum class Kind {
    published,  ///< a block of a message that was published
    free,       ///< such a block, which no message has any more
    replaced,   ///< the heap buffer of an array that moved to shared memory
  };
  Kind kind;
  const char* topic;
  std::uint64_t number;  ///< of the message
  const std::uint8_t* begin;
  std::size_t size;
  const CallStack* since;  ///< what published or replaced it
};

/// Before the first report, outside of signal handlers. Idempotent.
void prepare_reports();
/// So many blocks have been published, for the line at the end.
void count_published() noexcept;
/// Writes a report to stderr, the first time for each place in the program, and counts. Ends the process where TZC_GUARD
/// says so. Async-signal-safe.
void report(const Stale& stale, const posix::WriteFault& fault) noexcept;

/// Blocks, and heap buffers, that are kept from reuse: TZC_GUARD_QUARANTINE.
std::size_t quarantined_blocks() noexcept;
/// The number that MessageNumber gave this thread, or else `otherwise`.
std::uint64_t message_number(std::uint64_t otherwise) noexcept;

}  // namespace guard
}  // namespace tzc
