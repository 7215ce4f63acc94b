// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <clang/AST/Type.h>

namespace tzc::rewriter {

/// std::pair<It, int> and the like: the one view that makes, of what it is given, what its own type says.
bool is_pair(clang::QualType type);
/// A pointer or reference to an array, or a pair with one.
bool points_to_array(clang::QualType type);

}  // namespace tzc::rewriter
