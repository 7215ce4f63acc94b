// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace tzc {
namespace detail {

/// "a, b or c".
std::string listed(const std::vector<std::string>& words);

/// The valid word that `word` is most like, if it is like one: a few letters apart, or without its underscores.
/// As " (did you mean <prefix>word?)", or empty.
std::string did_you_mean(const std::string& word, const std::vector<std::string>& valid,
                         const std::string& prefix = std::string());

}  // namespace detail
}  // namespace tzc
