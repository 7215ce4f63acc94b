// SPDX-License-Identifier: BSD-3-Clause
#include "report/utf8.h"

namespace tzc::rewriter {
namespace {

unsigned char at(std::string_view text, std::size_t i) {
  return i < text.size() ? static_cast<unsigned char>(text[i]) : 0;
}

bool continues(unsigned char byte) {
  return (byte & 0xC0) == 0x80;
}

/// Bytes of the character that begins at `i`; 0: none does. RFC 3629: no overlong forms, no surrogates, no more
/// than U+10FFFF.
std::size_t character_at(std::string_view text, std::size_t i) {
  const unsigned char first = at(text, i), second = at(text, i + 1);
  if (first < 0x80) return 1;
  if (first >= 0xC2 && first <= 0xDF) return continues(second) ? 2 : 0;
  const unsigned char low = first == 0xE0 ? 0xA0 : first == 0xF0 ? 0x90 : 0x80;
  const unsigned char high = first == 0xED ? 0x9F : first == 0xF4 ? 0x8F : 0xBF;
  if (first < 0xE0 || first > 0xF4 || second < low || second > high || !continues(at(text, i + 2))) return 0;
  if (first < 0xF0) return 3;
  return continues(at(text, i + 3)) ? 4 : 0;
}

bool is_forbidden(unsigned char byte) {
  return byte == 0x7F || (byte < 0x20 && byte != '\t' && byte != '\n' && byte != '\r');
}

}  // namespace

std::string valid_utf8(std::string_view text) {
  std::string valid;
  valid.reserve(text.size());
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = is_forbidden(at(text, i)) ? 0 : character_at(text, i);
    valid += length == 0 ? std::string_view("\xEF\xBF\xBD") : text.substr(i, length);
    i += length == 0 ? 1 : length;
  }
  return valid;
}

}  // namespace tzc::rewriter
