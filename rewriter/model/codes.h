// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace tzc::rewriter::codes {

/// The codes as constants: codes::TZC1001 == "TZC1001".
#define X(code, slug, title) inline constexpr const char* code = #code;
#include "model/codes.def"
#undef X

}  // namespace tzc::rewriter::codes
