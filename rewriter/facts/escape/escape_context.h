// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "facts/escape/hidden_calls.h"
#include "facts/flow/value_flow.h"
#include "facts/syntax/known_functions.h"

namespace tzc::rewriter {

/// What the analysis of escapes reads, and where it writes what it finds.
struct EscapeContext {
  const Unit& unit;
  EntityTable& entities;
  ValueFlow& flow;
  EscapeFacts& found;
  HiddenCode& hidden;

  /// By the table of libraries' functions, or by the workspace's own, on which the level of the messages rests then. A function of
  /// the package may be called read(), too.
  Keeping keeping_of(const clang::FunctionDecl* callee, const std::vector<EntityId>& messages) const {
    const std::string function = qualified_name_of(callee);
    const Keeping known = unit.declares(callee) ? Keeping::unknown : rewriter::keeping_of(function);
    const auto trusted = unit.trusted.find(function);
    if (known != Keeping::unknown || trusted == unit.trusted.end()) return known;
    for (const EntityId& key : messages) found.trusted_calls.push_back({key, function, trusted->second});
    return Keeping::nothing;
  }
  std::vector<EntityId> sources_of(const clang::Expr* expr) const { return flow.sources_of(expr).entities; }
};

}  // namespace tzc::rewriter
