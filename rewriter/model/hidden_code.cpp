// SPDX-License-Identifier: BSD-3-Clause
#include "model/hidden_code.h"

#include <algorithm>

namespace tzc::rewriter {

bool IfShown::is_met_by(const Names& shown) const {
  return !names_ ||
         std::any_of(names_->begin(), names_->end(), [&](auto& name) { return shown.count(name) != 0; });
}

bool IfShown::covers(const IfShown& other) const {
  if (names_ == other.names_ || !names_) return true;
  return other.names_ &&
         std::includes(names_->begin(), names_->end(), other.names_->begin(), other.names_->end());
}

std::optional<IfShown> either(const std::optional<IfShown>& a, const std::optional<IfShown>& b) {
  if (!a || (b && b->covers(*a))) return b;
  if (!b || a->covers(*b)) return a;
  IfShown::Names names = *a->names();
  names.insert(b->names()->begin(), b->names()->end());
  return IfShown(std::move(names));
}

}  // namespace tzc::rewriter
