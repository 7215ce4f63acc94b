// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// packages ──parse──> facts ──solve──> components ──rules──> edits ──verify (demote, again)──> PortPlans
//                                                                                                 │
//              report (text, JSON, SARIF, HTML) <── tool ──> diff / staged files, swapped in together

#include "engine/options.h"
#include "engine/port_plan.h"
#include "model/expected.h"

namespace tzc::rewriter {

/// Parses, solves, edits, verifies, demotes: all packages of the options as one. Writes nothing. An error when a file
/// does not parse, or when the report does not hold every call of a package that advertises, publishes or subscribes.
Expected<PortPlans> plan_ports(const EngineOptions& options);

/// The same for a single package.
Expected<PortPlan> plan_port(const EngineOptions& options);

}  // namespace tzc::rewriter
