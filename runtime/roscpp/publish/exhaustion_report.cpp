// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/publish/exhaustion_report.h"

#include <unistd.h>

#include <sstream>

#include "roscpp/megabyte.h"

namespace tzc {
namespace detail {
namespace {

using Cause = AllocationError::Cause;

/// A memory for fewer is hardly one: one in a callback, one that waits, one in flight, one that is being filled.
constexpr std::size_t kFewMessages = 4;

/// What the queue and one subscriber use at once: the queue and the record that goes with it (decision 509), a message that
/// is being filled, one in a callback and one that waits for it.
std::size_t messages_at_once(const MemoryOptions& options) {
  return options.queue_size + 4;
}

/// In whole megabytes. Blocks are up to a sixteenth larger than what is in them, or end at a page; and of a memory with a size
/// bursts may have a sixteenth.
std::size_t enough_megabytes(std::size_t message_bytes, const MemoryOptions& options) {
  const auto page = static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
  const std::size_t blocks = messages_at_once(options) * (message_bytes + message_bytes / 16 + page);
  const std::size_t with_bursts = blocks + blocks / 15;
  return (with_bursts + kMegabyte - 1) / kMegabyte;
}

std::size_t most_bytes(const MemoryOptions& options) {
  return options.size != 0 ? options.size : options.ceiling;
}

std::string size_now(const MemoryOptions& options) {
  return (options.size != 0 ? "now " : "now up to ") + std::to_string(most_bytes(options));
}

/// The arrays of a message may fit one by one, and yet not together.
AllocationError of_the_whole_message(AllocationError failure, std::size_t message_bytes,
                                     const MemoryOptions& options) {
  if (failure.cause != Cause::in_use || message_bytes <= most_bytes(options)) return failure;
  failure.cause = Cause::too_large;
  failure.hint = "the message is larger than the whole memory";
  return failure;
}

std::string usage(const Exhaustion& what, const MemoryStats& memory) {
  std::ostringstream text;
  text << ". " << memory.used_bytes << " of " << memory.size_bytes << " bytes are in use, by "
       << memory.used_blocks << " blocks";
  if (!what.in_flight.empty()) text << "; sent and not taken yet: " << what.in_flight;
  return text.str();
}

/// Where the system refuses memory a larger size would not get more of it, and the failure says what would. But a memory that
/// has room for some messages can do without more, and leaves it to the rest of the process.
std::string advice_to_a_short_one(const Exhaustion& what, const MemoryOptions& options,
                                  const MemoryStats& memory) {
  const std::size_t megabytes = memory.reserved_bytes / kMegabyte;
  if (megabytes * kMegabyte < kFewMessages * what.message_bytes || megabytes == 0 ||
      megabytes * kMegabyte >= most_bytes(options))
    return "";
  return ". A smaller memory is possible: with ~tzc/memory_size at " + std::to_string(megabytes) +
         "M, which it has, or less, it asks the system for no more (" + size_now(options) + ")";
}

std::string advice(const Exhaustion& what, const MemoryOptions& options, const MemoryStats& memory,
                   Cause cause) {
  if (cause == Cause::system) return advice_to_a_short_one(what, options, memory);
  const std::size_t enough = enough_megabytes(what.message_bytes, options);
  if (enough * kMegabyte <= most_bytes(options))
    return ". This should be enough for the queue and one subscriber: see which subscriber keeps its "
           "messages "
           "(tzc-monitor), or raise ~tzc/memory_size (" +
           size_now(options) + ")";
  const std::string size =
      ". Set ~tzc/memory_size to " + std::to_string(enough) + "M or more (" + size_now(options) + ")";
  return cause == Cause::too_large ? size : size + ", or see which subscriber keeps its messages";
}

}  // namespace

std::string exhaustion_report(const Exhaustion& what, const MemoryOptions& options, const MemoryStats& memory,
                              const AllocationError& failure) {
  const AllocationError why = of_the_whole_message(failure, what.message_bytes, options);
  std::ostringstream text;
  text << what.topic << ": no shared memory for a message of " << what.message_bytes << " bytes";
  if (why.cause != Cause::none) text << " (" << why.text() << ")";
  text << ". It is "
       << (what.outcome == OnExhausted::drop ? "dropped, as ~tzc/on_exhausted says" : "sent serialized")
       << "; " << what.so_far << " so far";
  if (why.cause != Cause::too_large && memory.used_blocks > 0) text << usage(what, memory);
  text << advice(what, options, memory, why.cause);
  return text.str();
}

}  // namespace detail
}  // namespace tzc
