// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "tool/answer.h"

namespace tzc::rewriter {

/// The page of a code; for an unknown one the codes that are closest, with status 2.
Answer explain(const std::string& code_or_slug);

std::string list_of_codes();

}  // namespace tzc::rewriter
