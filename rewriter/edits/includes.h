// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <set>
#include <string>

#include "model/edit.h"

namespace tzc::rewriter {

/// File -> the headers that its new text needs: "tzc/ros.h".
using NeededHeaders = std::map<std::string, std::set<std::string>>;

/// The edits that include what is not included yet, behind the include that each header belongs to, for the other edits of
/// these files.
Edits include_edits(const NeededHeaders& needed, const Edits& others, const ReadFile& read);

}  // namespace tzc::rewriter
