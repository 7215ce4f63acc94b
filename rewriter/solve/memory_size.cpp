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
  const std::uint64_t messages = std::max<std::uint64_t>(4, number_in(fact.queue).value_or(10) + 2);
  const std::uint64_t bytes = measured->second * messages;
  return {std::to_string(bytes), std::to_string(messages) + " messages of " +
                                     std::to_string(measured->second) +
                                     " bytes, the largest in the recording"};
}

}  // namespace tzc::rewriter
