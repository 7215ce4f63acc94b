// SPDX-License-Identifier: BSD-3-Clause
#include "format/brackets.h"

namespace tzc::rewriter {
namespace {

/// Behind a string or character literal that begins at `at`.
std::size_t behind_literal(std::string_view line, std::size_t at) {
  const char quote = line[at];
  for (++at; at < line.size() && line[at] != quote; ++at)
    if (line[at] == '\\') ++at;
  return at;
}

}  // namespace

Brackets brackets_of(std::string_view line) {
  Brackets found;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (c == '/' && i + 1 < line.size() && line[i + 1] == '/') break;
    if (c == '"' || c == '\'') i = behind_literal(line, i);
    if (c == '(' || c == '[' || c == '{') found.open.push_back(i);
    if (c != ')' && c != ']' && c != '}') continue;
    if (found.open.empty())
      ++found.closed;
    else
      found.open.pop_back();
  }
  return found;
}

}  // namespace tzc::rewriter
