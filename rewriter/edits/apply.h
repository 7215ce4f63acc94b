// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "model/edit.h"
#include "model/expected.h"

namespace tzc::rewriter {

/// Applies the edits of one file. Insertions at one place keep their order, identical duplicates count once;
/// edits that overlap or leave the content are an error that names the rules.
Expected<std::string> apply_edits(std::string_view content, const Edits& edits);

/// Edits of any files that change the same text in different ways, the later one second.
std::vector<std::pair<Edit, Edit>> overlaps(const Edits& edits);

/// The edits of one file as apply_edits applies them: by place, duplicates dropped.
Edits in_order(const Edits& edits);

/// Edits by file, each list in the order given.
std::map<std::string, Edits> by_file(const Edits& edits);

}  // namespace tzc::rewriter
