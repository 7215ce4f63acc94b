// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace tzc::rewriter {

/// The text with U+FFFD for each byte that is not part of a character of UTF-8, and for control characters that no
/// document may hold. Sources are in any encoding.
std::string valid_utf8(std::string_view text);

}  // namespace tzc::rewriter
