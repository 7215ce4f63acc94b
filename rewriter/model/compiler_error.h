// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <set>
#include <string>
#include <vector>

#include "model/edit.h"
#include "model/expected.h"
#include "model/location.h"

namespace tzc::rewriter {

/// A compiler's error, with the user's paths and the lines of the compiled text.
struct CompilerError {
  std::string unit;  ///< main file, canonical
  Location where;
  std::string text;
  std::vector<Location> notes;  ///< places that led there or that its notes name
};

/// Runs the package's compiler on units (canonical main files), with the edited text in place of the files'
/// own. Leaves out errors that the sources have without that text.
using CompilerCheck = std::function<Expected<std::vector<CompilerError>>(const FileContents& contents,
                                                                         const std::set<std::string>& units)>;

}  // namespace tzc::rewriter
