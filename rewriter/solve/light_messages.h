// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "solve/components.h"
#include "solve/solution.h"

namespace tzc::rewriter {

/// Treats sites of types whose arrays hold fewer than `small` bytes as if they had no array.
void leave_light_types(Facts& facts, std::uint64_t small);

/// Whether what a site publishes needs no shared memory, by its type or by what was decided on its message.
bool publishes_light_message(const Publish& site, const Components& components, const Solution& solution);

/// Messages whose arrays are shown to stay small by every use that the package makes of them.
class LightMessages {
 public:
  LightMessages(const Facts& facts, const Components& components);

  /// How many bytes the arrays of a message of the component hold at most. None: any number. The component must
  /// have no obstacle, and none of its messages may start as a copy of another one.
  std::optional<std::uint64_t> most_bytes(const Component& component) const;
  /// Whether the package mentions an array of its messages at all.
  bool mentions_arrays(const Component& component) const { return uses_.count(component.id) != 0; }

 private:
  std::map<ComponentId, std::vector<const DataUse*>> uses_;
  std::set<ComponentId> unbounded_;
};

}  // namespace tzc::rewriter
