// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "model/compiler_error.h"
#include "model/expected.h"

namespace tzc::rewriter {

/// The judges of a port besides Clang, and what they judge; each may be empty.
struct Judges {
  /// The text that is written: (path, original, edited) to text. Formatting, --dual.
  std::function<Expected<std::string>(const std::string&, const std::string&, const std::string&)>
      written_text;
  CompilerCheck compiler;  ///< called when Clang accepts the edits
  /// The errors that the compiler has against a unit as it is.
  std::function<Expected<std::vector<CompilerError>>(const std::string& unit)> original_errors;
};

}  // namespace tzc::rewriter
