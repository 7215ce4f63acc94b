// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

#include "buildfiles/cmake_file.h"
#include "model/edit.h"

namespace tzc::rewriter {

/// "\r\n" when the file's first line ends so, else "\n".
std::string line_ending(std::string_view content);

/// The blanks between the start of the line and `offset`, or what precedes the first non-blank of that line.
std::string indentation(std::string_view content, std::size_t offset);

/// Adds an argument after the `index`th in the style of the command: on a line of its own when the arguments
/// stand so (behind a comment at the line's end), else after a blank.
Edit add_argument(const std::string& path, std::string_view content, const CmakeCommand& command,
                  std::size_t index, const std::string& text);

/// Adds a line after the one that holds `offset`, indented alike.
Edit add_line(const std::string& path, std::string_view content, std::size_t offset, const std::string& text);

/// Adds a command behind another one, on a line of its own that is indented like the other one's first.
Edit add_command(const std::string& path, std::string_view content, const CmakeCommand& before,
                 const std::string& text);

}  // namespace tzc::rewriter
