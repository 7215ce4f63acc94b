// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "edits/expected.h"

namespace tzc::rewriter {

/// One replacement of a byte range. `length` 0 inserts, an empty `text` deletes.
struct Edit {
  std::string file;  ///< absolute, canonical
  std::size_t offset = 0;
  std::size_t length = 0;
  std::string text;
  int component = -1;  ///< the component of the flow graph it belongs to; -1: of the file as a whole
  std::string rule;    ///< the rule that wants it, for messages
};
using Edits = std::vector<Edit>;

/// Path -> new content: what verify parses and staging writes.
using FileContents = std::map<std::string, std::string>;

/// Applies the edits of one file. Insertions at one place keep their order, identical duplicates count once;
/// edits that overlap or leave the content are an error that names the rules.
Expected<std::string> apply_edits(std::string_view content, const Edits& edits);

/// Edits by file, each list in the order given.
std::map<std::string, Edits> by_file(const Edits& edits);

}  // namespace tzc::rewriter
