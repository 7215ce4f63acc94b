// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

namespace tzc::rewriter {

/// Moves the elements of one vector behind those of another.
template <class T>
void append(std::vector<T>& into, std::vector<T>& from) {
  std::move(from.begin(), from.end(), std::back_inserter(into));
}

}  // namespace tzc::rewriter
