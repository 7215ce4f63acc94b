// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "model/facts.h"
#include "model/solve_options.h"
#include "solve/components.h"
#include "solve/flow_graph.h"
#include "solve/site_index.h"
#include "solve/solution.h"

namespace tzc::rewriter {

/// Publishers that keep their class: those of other code, and those that cannot be ported. Shared memory is attached to their topics
/// where the package publishes (tzc::publish) or advertises (tzc::attached). The arguments must outlive it; the solution has the
/// decisions on publishers.
class KeptPublishers {
 public:
  KeptPublishers(const Facts& facts, const Components& components, const SolveOptions& options,
                 const Solution& solution);

  /// Whether the call can publish the port's message with such a publisher, without a copy.
  bool take_ported_message(const Publish& site) const;
  /// After messages are decided.
  Decision decide_publish_call(const Component& call) const;
  /// After publish calls are decided.
  Decision decide_advertise_call(const Component& call) const;

 private:
  bool is_of_other_code(const EntityId& publisher) const;
  bool is_kept(const EntityId& publisher) const;
  std::optional<Decision> obstacle_at(const Component& call) const;
  bool publishes_ported_message(const Publish& site) const;
  bool needs_memory(const Advertise& site) const;
  bool needs_memory_beside_calls(const Component& publisher) const;

  const Facts& facts_;
  const Components& components_;
  const SolveOptions& options_;
  const Solution& solution_;
  SiteIndex sites_;
  FlowGraph flow_graph_;
};

}  // namespace tzc::rewriter
