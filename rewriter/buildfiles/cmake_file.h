// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "model/expected.h"

namespace tzc::rewriter {

/// An argument of a CMake command with its place in the file; a list inside a quoted argument stays one
/// argument.
struct CmakeArgument {
  std::string text;       ///< without quotes or brackets; variable references unexpanded
  std::size_t begin = 0;  ///< of the argument as written, quotes included
  std::size_t end = 0;
  bool bracket = false;  ///< [[...]]: nothing in it is expanded
};

struct CmakeCommand {
  std::string name;       ///< lower case
  std::size_t begin = 0;  ///< of the name
  std::size_t open = 0;   ///< offset after '('
  std::size_t close = 0;  ///< offset of ')'
  std::vector<CmakeArgument> arguments;
};

/// Whether a file is called as CMake's files are: CMakeLists.txt, CMakeLists_ros1.txt, nodes.cmake. A file that include() brings in may have
/// any name.
bool has_cmake_name(const std::string& file);

/// As CMake compares names of commands.
std::string lower_case(std::string text);

/// The commands of a file, in order. Control flow is not interpreted: if(), foreach(), function() are
/// commands like others. An error where the file is no CMake: an unclosed parenthesis, quote or bracket.
Expected<std::vector<CmakeCommand>> parse_cmake(std::string_view content, const std::string& path);

/// The position of the argument with this text in a command; npos: there is none.
std::size_t find_argument(const CmakeCommand& command, std::string_view text, std::size_t from = 0);

}  // namespace tzc::rewriter
