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

std::string_view without_comment(std::string_view line) {
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line.substr(i, 2) == "//") return line.substr(0, i);
    if (line[i] == '"' || line[i] == '\'') i = behind_literal(line, i);
  }
  return line;
}

Brackets brackets_of(std::string_view line) {
  Brackets found;
  line = without_comment(line);
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
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
