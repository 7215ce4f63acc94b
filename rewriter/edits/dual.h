// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "model/expected.h"

namespace tzc::rewriter {

/// The macro that chooses between the two readings of a source of --dual.
constexpr const char* dual_macro = "TZC_ENABLED";

/// A source that reads as `after` where the macro is defined and as `before` where it is not: each run of
/// changed lines stands in an #ifdef of its own. An error where a change lies inside a directive or a comment
/// that spans lines, which cannot hold an #ifdef.
Expected<std::string> dual_text(const std::string& path, const std::string& before, const std::string& after);

/// Whether a line (from 1) lies in, or is, a branch that dual_text() made.
bool in_dual_branch(const std::string& content, unsigned line);

}  // namespace tzc::rewriter
