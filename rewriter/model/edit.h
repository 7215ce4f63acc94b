// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "model/ids.h"

namespace tzc::rewriter {

/// One replacement of a byte range. `length` 0 inserts, an empty `text` deletes.
struct Edit {
  std::string file;  ///< absolute, canonical
  std::size_t offset = 0;
  std::size_t length = 0;
  std::string text;
  std::optional<ComponentId> component;  ///< to which it belongs; none: it belongs to the file as a whole
  std::string rule;                      ///< the rule that asks for it, for messages
};
using Edits = std::vector<Edit>;

/// Path -> new content: what verify parses and staging writes.
using FileContents = std::map<std::string, std::string>;

/// Reads a file; none: it cannot be read.
using ReadFile = std::function<std::optional<std::string>(const std::string& path)>;

}  // namespace tzc::rewriter
