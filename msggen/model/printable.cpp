// SPDX-License-Identifier: BSD-3-Clause
#include "model/printable.h"

#include <algorithm>

namespace tzc::msggen {
namespace {

unsigned byte_at(std::string_view text, std::size_t i) {
  return i < text.size() ? static_cast<unsigned char>(text[i]) : 0;
}

std::size_t length_by_first_byte(unsigned first) {
  return first < 0x80 ? 1 : first < 0xC2 ? 0 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : first < 0xF5 ? 4 : 0;
}

// How many bytes the text's first character takes; 0 if it is cut or no UTF-8.
std::size_t character_length(std::string_view text) {
  const std::size_t length = length_by_first_byte(byte_at(text, 0));
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte_at(text, i) & 0xC0) != 0x80) return 0;
  }
  return length;
}

bool is_control(std::string_view character) {
  const unsigned first = byte_at(character, 0);
  if (character.size() == 2) return first == 0xC2 && byte_at(character, 1) < 0xA0;  // C1
  return character.size() == 1 && first != '\t' && (first < 0x20 || first == 0x7F);
}

}  // namespace

std::string printable(std::string_view text, std::size_t longest) {
  std::string clean;
  while (!text.empty()) {
    const std::size_t length = character_length(text);
    const std::string_view character = text.substr(0, std::max<std::size_t>(length, 1));
    if (clean.size() + character.size() > longest) break;
    clean += length == 0 || is_control(character) ? "?" : character;
    text.remove_prefix(character.size());
  }
  return clean;
}

}  // namespace tzc::msggen
