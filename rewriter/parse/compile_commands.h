// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "model/expected.h"

namespace tzc::rewriter {

/// How one translation unit is compiled.
struct CompileUnit {
  std::string file;  ///< absolute, canonical
  std::string directory;
  std::vector<std::string> arguments;

  /// Tells it from the same file compiled for another target.
  std::string id() const {
    std::string text = file;
    for (const std::string& argument : arguments) text += "\n" + argument;
    return text;
  }
};

/// The units of a package in a build folder's compile_commands.json. An error when there are none.
Expected<std::vector<CompileUnit>> load_units(const std::string& package_dir, const std::string& build_dir);

}  // namespace tzc::rewriter
