// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "model/edit.h"

namespace tzc::rewriter {

/// Gives the text of each edit the line endings of its file.
void keep_line_endings(Edits& edits, const ReadFile& read);

}  // namespace tzc::rewriter
