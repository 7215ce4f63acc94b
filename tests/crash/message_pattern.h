// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "tzc/channel.h"

namespace tzc {
namespace crash {

/// A message of several blocks whose every byte follows from its seed. Null: no memory.
channel::RecordPtr make_patterned(SegmentMemory& memory, std::uint64_t seed);
/// True when no byte of it was changed.
bool is_intact(const channel::Message& message);

}  // namespace crash
}  // namespace tzc
