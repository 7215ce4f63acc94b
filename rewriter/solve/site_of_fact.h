// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "model/facts.h"
#include "model/site.h"
#include "solve/flow_graph.h"

namespace tzc::rewriter {

/// A site as far as the facts know it, without a level; its id still lacks the ordinal.
Site site_of(const Advertise& fact, const std::string& package_dir);
Site site_of(const Publish& fact, const std::string& package_dir);
Site site_of(const Subscribe& fact, const std::string& package_dir);

/// The topic of a publisher that is advertised once.
std::optional<std::string> topic_of(const Facts& facts, const FlowGraph& graph, const EntityId& publisher);

}  // namespace tzc::rewriter
