// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>
#include <vector>

namespace tzc::rewriter {

struct CodeInfo {
  std::string_view code;
  std::string_view slug;
  std::string_view title;
  std::string_view page;  ///< the whole text of docs/diagnostics/TZCnnnn.md
};

/// Every code, ascending.
const std::vector<CodeInfo>& all_codes();

/// Null when there is no such code. Takes the code or its slug.
const CodeInfo* find_code(std::string_view code_or_slug);

}  // namespace tzc::rewriter
