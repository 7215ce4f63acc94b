// SPDX-License-Identifier: BSD-3-Clause
#include "report/utf16.h"

namespace tzc::rewriter {

std::size_t utf16_length(std::string_view text) {
  std::size_t units = 0;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if ((byte & 0xC0) != 0x80) ++units;  // not in the middle of a character
    if (byte >= 0xF0) ++units;           // a pair of surrogates
  }
  return units;
}

unsigned utf16_column(std::string_view source, unsigned line, unsigned byte_column) {
  for (; line > 1; --line) {
    const std::size_t end = source.find('\n');
    if (end == std::string_view::npos) return byte_column;
    source.remove_prefix(end + 1);
  }
  const std::string_view text = source.substr(0, source.find('\n'));
  if (byte_column == 0 || byte_column - 1 > text.size()) return byte_column;
  return static_cast<unsigned>(utf16_length(text.substr(0, byte_column - 1))) + 1;
}

}  // namespace tzc::rewriter
