// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace tzc::rewriter {

/// Which lines of a C++ source belong to one statement, by how lines end and by the parentheses that are open: a port may
/// break a line, and what is said of the line holds for the statement. Lines count from 1.
class StatementLines {
 public:
  explicit StatementLines(const std::string& source);

  /// Where the statement begins that has its end, or its middle, in a line.
  unsigned first(unsigned line) const;
  /// Where the statement ends that begins in a line.
  unsigned last(unsigned line) const;

 private:
  struct Line {
    int opened = 0;     ///< parentheses, less those that it closes
    bool ends = false;  ///< what follows is another statement
  };
  static Line read(const std::string& code);

  std::vector<Line> lines_;
};

}  // namespace tzc::rewriter
