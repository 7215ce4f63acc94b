// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/publish/exhaustion_report.h"

#include <algorithm>
#include <sstream>

namespace tzc {
namespace detail {
namespace {

/// Enough for what the queue, the publisher and a slow subscriber use at once, in whole megabytes.
std::string enough_memory(std::size_t message_bytes, std::size_t queue_size) {
  const std::size_t messages = std::max<std::size_t>(4, queue_size + 2);
  const std::size_t megabyte = std::size_t{1} << 20;
  return std::to_string((messages * message_bytes + megabyte - 1) / megabyte) + "M";
}

}  // namespace

std::string exhaustion_report(const Exhaustion& what, const MemoryOptions& options, const MemoryStats& memory,
                              const std::string& failure) {
  std::ostringstream text;
  text << what.topic << ": no shared memory for a message of " << what.message_bytes << " bytes";
  if (!failure.empty()) text << " (" << failure << ")";
  text << ". It is "
       << (what.outcome == OnExhausted::drop ? "dropped, as ~tzc/on_exhausted says" : "sent serialized")
       << "; " << what.so_far << " so far. " << memory.used_bytes << " of " << memory.size_bytes
       << " bytes are in use, by " << memory.used_blocks << " blocks";
  if (!what.in_flight.empty()) text << "; sent and not taken yet: " << what.in_flight;
  text << ". Set ~tzc/memory_size to " << enough_memory(what.message_bytes, options.queue_size)
       << " or more (now "
       << (options.size != 0 ? std::to_string(options.size) : "up to " + std::to_string(options.ceiling))
       << "), or see which subscriber keeps its messages";
  return text.str();
}

}  // namespace detail
}  // namespace tzc
