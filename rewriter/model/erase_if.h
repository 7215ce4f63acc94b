// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <vector>

namespace tzc::rewriter {

/// As std::erase_if of C++20.
template <class T, class Predicate>
void erase_if(std::vector<T>& items, Predicate is_out) {
  items.erase(std::remove_if(items.begin(), items.end(), is_out), items.end());
}

}  // namespace tzc::rewriter
