// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "edits/edited_lines.h"
#include "model/edit.h"
#include "model/facts.h"
#include "parse/parse.h"
#include "solve/components.h"

namespace tzc::rewriter {

/// Edits, what is written because of them, and how the originals are read.
struct EditedSources {
  const Edits& edits;
  const FileContents& contents;
  ReadFile read;
};

/// Which components may have caused an error of the edited sources.
class Attribution {
 public:
  Attribution(const Facts& facts, const Components& components, EditedSources sources);

  /// The components with an edit on a line of the error or of its notes, likeliest first; empty: there is
  /// none.
  std::vector<ComponentId> suspects_of(const Diagnostic& error) const;

  /// Edited components one of whose entities is named on such a line: a first guess for an error that no
  /// component owns.
  std::set<ComponentId> named_at(const Diagnostic& error) const;

  /// Edited components with an edit in one of the files.
  std::set<ComponentId> edited_in(const std::set<std::string>& files) const;

  /// Whether one of these rules asked for an edit on a line of the original.
  bool has_edit(const std::string& file, unsigned line, const std::set<std::string>& rules) const;

  /// Lines of the original that a line of an edited file stands for.
  LineRange original(const std::string& file, unsigned line) const;

 private:
  bool owns_line(ComponentId component, const std::string& file, const LineRange& lines) const;
  std::string edited_line(const Location& where) const;

  const Facts& facts_;
  const Components& components_;
  const FileContents& contents_;
  ReadFile read_;
  std::set<ComponentId> edited_;
  std::map<std::string, EditedLines> lines_;
  std::map<std::string, std::map<ComponentId, std::set<unsigned>>>
      edited_lines_;  ///< file -> component -> original lines
  std::map<std::string, std::map<unsigned, std::set<std::string>>>
      rules_;  ///< file -> original line -> rules of the edits there
};

}  // namespace tzc::rewriter
