// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <clang/Tooling/Core/Replacement.h>

#include <string>

namespace tzc::rewriter {

/// `after` with those of clang-format's replacements that lie in lines which `before` does not have. For any style and any file:
/// - no other line changes, as replacements that begin or end in one are left out, unless only the line break in front of a changed line is in it;
/// - a changed line that begins a statement keeps its indentation, as replacements of the break in front of it are left out;
/// - a line that continues a statement stands to its bracket, or to the line of that, as clang-format has it; where that line stands
///   is the file's affair.
/// Empty where the replacements change more than white space, or cannot be applied.
std::string with_changed_lines_styled(const std::string& before, const std::string& after,
                                      const clang::tooling::Replacements& replacements, unsigned tab_width);

}  // namespace tzc::rewriter
