// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace tzc::rewriter {

/// `after` with continuation lines that stood behind a bracket of a changed line standing behind it again. Lines that
/// were not aligned with a bracket, and files whose brackets do not pair up line by line, stay as they are.
std::string realigned(const std::string& before, const std::string& after);

}  // namespace tzc::rewriter
