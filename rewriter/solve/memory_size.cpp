// SPDX-License-Identifier: BSD-3-Clause
#include "solve/memory_size.h"

#include <algorithm>
#include <cctype>

namespace tzc::rewriter {
namespace {

std::optional<std::uint64_t> number_in(const std::optional<std::string>& text) {
  if (!text || text->empty() ||
      !std::all_of(text->begin(), text->end(), [](char c) { return std::isdigit(c) != 0; }))
    return {};
  return text->size() > 9 ? std::nullopt : std::optional<std::uint64_t>(std::stoull(*text));
}

/// The queue and the record that goes with it, a message that is being filled, one in a callback and one that waits for it. As the
/// runtime counts when it says which size would be enough (runtime/roscpp/publish/exhaustion_report.cpp).
std::uint64_t messages_at_once(const std::optional<std::string>& queue) {
  return number_in(queue).value_or(10) + 4;
}

/// Blocks are up to a sixteenth larger than what is in them, or end at a page; bursts may have a sixteenth of the whole.
std::uint64_t bytes_for(std::uint64_t messages, std::uint64_t message_bytes) {
  constexpr std::uint64_t page = 4096;
  const std::uint64_t blocks = messages * (message_bytes + message_bytes / 16 + page);
  return blocks + blocks / 15;
}

}  // namespace

MemorySize memory_size(const Advertise& fact, const SolveOptions& options) {
  if (fact.memory && *fact.memory != "0") return {*fact.memory, "set to " + *fact.memory + " in the source"};
  if (fact.memory) return {"0", "sized at run time by the first message and the queue"};
  if (options.mem_size)
    return {std::to_string(*options.mem_size),
            "set to " + std::to_string(*options.mem_size) + " bytes by --mem-size"};
  const auto measured = fact.topic ? options.measured_sizes.find(*fact.topic) : options.measured_sizes.end();
  if (measured == options.measured_sizes.end())
    return {"0", "sized at run time by the first message and the queue"};
  const std::uint64_t messages = messages_at_once(fact.queue);
  return {std::to_string(bytes_for(messages, measured->second)),
          "room for " + std::to_string(messages) + " messages of " + std::to_string(measured->second) +
              " bytes, the largest in the recording"};
}

}  // namespace tzc::rewriter
