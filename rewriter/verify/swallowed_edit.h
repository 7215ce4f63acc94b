// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "model/edit.h"

namespace tzc::rewriter {

/// The edit behind which the code of `edited` is not what was meant: the original's tokens, with each edit's in place of those
/// that it replaces. A comment that goes on at the end of its line, an unclosed string or a directive may swallow what an edit
/// writes, or an edit what stands behind it; such a text often compiles. None: the code is as meant. `edits` are those of the
/// file that made `edited` of `original`.
std::optional<Edit> swallowed_edit(const std::string& original, const Edits& edits,
                                   const std::string& edited);

}  // namespace tzc::rewriter
