// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

#include "model.h"

namespace tzc::monitor {

/// "0", "512", "1.5K", "24.9M": in powers of 1024, at most five characters below 1000 T.
std::string short_bytes(double bytes);
/// "35 us", "2.1 ms", "4 s": two digits at least.
std::string short_time(double seconds);
const char* name(State state);
const char* name(Transport transport);
/// Why a connection is not shared, with the subscriber's name where the subscriber speaks of itself, and a full stop.
std::string named_reason(const Connection& connection);
/// What a user can do about a reason why a connection is not shared (docs/troubleshooting.md); empty: nothing is known.
std::string advice(const std::string& reason);

}  // namespace tzc::monitor
