// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace tzc::rewriter {

/// BLAKE3 of a text, in hexadecimal. Thread-safe.
std::string blake3_digest(std::string_view text);

}  // namespace tzc::rewriter
