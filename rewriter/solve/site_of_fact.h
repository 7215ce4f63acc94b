// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "model/facts.h"
#include "model/folder_set.h"
#include "model/site.h"
#include "solve/flow_graph.h"

namespace tzc::rewriter {

/// A site as far as the facts know it, without a level; its id still lacks the ordinal.
Site site_of(const Advertise& fact, const FolderSet& packages);
Site site_of(const Publish& fact, const FolderSet& packages);
Site site_of(const Subscribe& fact, const FolderSet& packages);

/// The topic of a publisher that is advertised once.
std::optional<std::string> topic_of(const Facts& facts, const FlowGraph& graph, const EntityId& publisher);

}  // namespace tzc::rewriter
