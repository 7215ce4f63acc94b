// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <set>
#include <string>

#include "edits/expected.h"

namespace tzc::rewriter {

/// Main file -> names of the CMake targets that compile it, read off the object files' places in
/// BUILD_DIR/compile_commands.json ("pkg/CMakeFiles/NAME.dir/src/x.cpp.o"). Paths are canonical.
Expected<std::map<std::string, std::set<std::string>>> targets_of_files(const std::string& build_dir);

/// Every file that the database has a command for.
Expected<std::set<std::string>> compiled_files(const std::string& build_dir);

}  // namespace tzc::rewriter
