// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "tool/answer.h"

namespace tzc::rewriter {

/// --undo without --apply: who types that wants to take a port back, and a dry run would show the port again. Ends
/// with what to type instead.
Answer undo_without_apply(const std::string& file, const std::vector<std::string>& packages);

}  // namespace tzc::rewriter
