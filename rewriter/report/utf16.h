// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string_view>

namespace tzc::rewriter {

/// The length of a text in UTF-8, in UTF-16 code units: what editors and SARIF count columns in.
std::size_t utf16_length(std::string_view text);

/// The column (from 1) in UTF-16 code units of a byte column (from 1) of a line (from 1) of a source. The byte column, when
/// the source has no such place.
unsigned utf16_column(std::string_view source, unsigned line, unsigned byte_column);

}  // namespace tzc::rewriter
