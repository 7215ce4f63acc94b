// SPDX-License-Identifier: BSD-3-Clause
#include "remarks/statement_lines.h"

#include <algorithm>
#include <sstream>
#include <string_view>

#include "edits/source_text.h"

namespace tzc::rewriter {

StatementLines::StatementLines(const std::string& source) {
  std::istringstream code(without_comments(source));
  for (std::string line; std::getline(code, line);) lines_.push_back(read(line));
}

StatementLines::Line StatementLines::read(const std::string& code) {
  Line line;
  line.opened =
      static_cast<int>(std::count(code.begin(), code.end(), '(') - std::count(code.begin(), code.end(), ')'));
  const std::size_t begin = code.find_first_not_of(" \t\r"), end = code.find_last_not_of(" \t\r");
  line.ends = end == std::string::npos || code[begin] == '#' ||
              std::string_view(";{}:").find(code[end]) != std::string_view::npos;
  return line;
}

/// The body of a lambda that is an argument has ends of its own: the statement goes on to where the call's parenthesis opens.
unsigned StatementLines::first(unsigned line) const {
  if (line == 0 || line > lines_.size()) return line;
  int opened = lines_[line - 1].opened;
  while (line > 1 && (opened < 0 || !lines_[line - 2].ends)) opened += lines_[--line - 1].opened;
  return line;
}

unsigned StatementLines::last(unsigned line) const {
  if (line == 0 || line > lines_.size()) return line;
  int opened = lines_[line - 1].opened;
  while (line < lines_.size() && (opened > 0 || !lines_[line - 1].ends)) opened += lines_[line++].opened;
  return line;
}

}  // namespace tzc::rewriter
