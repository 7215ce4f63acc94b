// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

#include "trace/event.h"

namespace tzc {
namespace trace {

/// Lines of Chrome's trace event format, JSON array flavour (docs/traces.md), each with its comma and end of line. Perfetto
/// reads them, too. Pure.
/// @{
/// A step: a slice, and the point of its message's flow.
std::string to_json(const Event& event, std::uint32_t process);
std::string process_name(std::uint32_t process, const std::string& name);
std::string thread_name(std::uint32_t process, std::uint32_t thread, const std::string& name);
/// How many events were dropped until then.
std::string dropped_count(std::uint32_t process, std::uint64_t at_ns, std::uint64_t dropped);
/// @}

}  // namespace trace
}  // namespace tzc
