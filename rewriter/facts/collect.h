// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "facts/syntax/unit.h"
#include "model/facts.h"

// declarations, expressions ──dispatch──> one collector per kind of site, which returns its facts
//                                   └───> ValueFlow ──> EntityTable, the sole writer of entities and flows
// at the end: Hoisting finds the publishers that are available where messages are allocated

namespace tzc::rewriter {

/// The facts of one translation unit, within its traversal scope.
Facts collect(const Unit& unit);

}  // namespace tzc::rewriter
