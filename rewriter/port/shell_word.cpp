// SPDX-License-Identifier: BSD-3-Clause
#include "port/shell_word.h"

#include <algorithm>
#include <cctype>

namespace tzc::rewriter {

std::string shell_word(const std::string& word) {
  static const std::string plain = "/._-+=:@%,";
  const bool safe = !word.empty() && std::all_of(word.begin(), word.end(), [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) || plain.find(c) != std::string::npos;
  });
  if (safe) return word;
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

}  // namespace tzc::rewriter
