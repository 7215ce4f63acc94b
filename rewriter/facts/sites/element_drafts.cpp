// SPDX-License-Identifier: BSD-3-Clause
#include "facts/sites/element_drafts.h"

#include <algorithm>
#include <string>
#include <variant>

#include "facts/sites/named_elements.h"

namespace tzc::rewriter {

std::vector<AllocationDraft> of_each_element(const std::optional<AllocationDraft>& declared) {
  if (!declared) return {};
  const std::vector<std::string> names =
      declared->variable ? few_messages_in(declared->variable) : std::vector<std::string>();
  std::vector<AllocationDraft> drafts(std::max<std::size_t>(names.size(), 1), *declared);
  for (std::size_t index = 0; index < names.size(); ++index)
    std::get<InsertedAllocation>(drafts[index].site.how).object = names[index];
  return drafts;
}

}  // namespace tzc::rewriter
