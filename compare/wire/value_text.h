// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "wire/definition.h"

namespace tzc::compare {

/// A builtin's value, from its `size` bytes on the wire, as people write it; long strings are cut.
std::string value_text(Kind kind, const std::uint8_t* bytes, std::size_t size);

}  // namespace tzc::compare
