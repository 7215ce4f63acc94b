// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "model/edit.h"

namespace tzc::rewriter {

/// Lines of an original, from 1, both ends included.
struct LineRange {
  unsigned first = 0, last = 0;
  bool has(unsigned line) const { return first <= line && line <= last; }
};

/// Maps a line of the written text to lines of the original. The effect of the edits is known exactly; the
/// effect of formatting and --dual is found by comparing.
class EditedLines {
 public:
  /// `edits` apply to `original`; `written` is their result, formatted or not.
  EditedLines(const std::string& original, const Edits& edits, const std::string& written);

  /// A line that an edit wrote stands for the line that the edit begins on.
  LineRange original(unsigned written_line) const;

 private:
  void learn_edits(const std::string& original, const Edits& edits);
  unsigned before_edits(unsigned line) const;

  struct EditedPlace {
    unsigned line = 0;  ///< of the original, on which the edit begins
    int grown = 0;      ///< lines that it adds
  };
  std::vector<EditedPlace> edits_;
  std::vector<LineRange> unformatted_;  ///< by written line
};

}  // namespace tzc::rewriter
