// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "model/location.h"

namespace tzc::rewriter {

/// File and line of an #if, #elif or #else.
using BranchDirective = std::pair<std::string, unsigned>;
/// File and offset of what a macro is given.
using ArgumentPlace = std::pair<std::string, unsigned>;

/// What the preprocessor keeps from the compiler, and what it makes a text of.
struct PreprocessorNotes {
  /// Branches that a unit does not compile, from their directive to one whose branch it compiles, or #endif: once for each time
  /// that the unit reads the file.
  std::vector<Place> skipped;
  std::set<BranchDirective> compiled;  ///< of the branches that it compiles, one of the times at least
  std::vector<Place>
      dropped;  ///< arguments of macros that the compiler does not get: of assert() under NDEBUG
  std::set<ArgumentPlace> kept;  ///< those that it gets
  std::vector<Place> texts;      ///< arguments that a macro makes a text of: #argument

  void merge(PreprocessorNotes&& other);
};

}  // namespace tzc::rewriter
