// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "report/output.h"

namespace tzc::rewriter {

std::string html_escaped(const std::string& text);

/// Escaped, with `code` in backquotes set as such.
std::string html_prose(const std::string& text);

/// A foldable side-by-side view of one changed file.
std::string html_diff(const FileChange& change, const std::string& anchor);

}  // namespace tzc::rewriter
