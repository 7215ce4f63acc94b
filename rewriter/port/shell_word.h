// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace tzc::rewriter {

/// A word as a shell takes it: in quotes where it needs them.
std::string shell_word(const std::string& word);

}  // namespace tzc::rewriter
