// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "parse/compile_commands.h"

namespace tzc::rewriter {

/// The unit as a debug build compiles it, without NDEBUG, under which assert() and its like drop what they are given; none: it is
/// compiled so already. A definition within the sources stays.
std::optional<CompileUnit> debug_build_of(const CompileUnit& unit);

}  // namespace tzc::rewriter
