// SPDX-License-Identifier: BSD-3-Clause
#include "facts/decided_branches.h"

#include <algorithm>
#include <optional>

namespace tzc::rewriter {
namespace {

/// Each doubles the ways.
constexpr std::size_t most_deciders = 2;

struct Condition {
  const clang::VarDecl* variable;
  bool negated;
};

/// if (wanted), if (!wanted); none: something else decides.
std::optional<Condition> condition_of(const clang::CFGBlock& block) {
  const auto* expr = llvm::dyn_cast_or_null<clang::Expr>(block.getTerminatorCondition());
  if (!expr || block.succ_size() != 2) return {};
  bool negated = false;
  for (expr = expr->IgnoreParenImpCasts();; expr = expr->IgnoreParenImpCasts()) {
    const auto* op = llvm::dyn_cast<clang::UnaryOperator>(expr);
    if (!op || op->getOpcode() != clang::UO_LNot) break;
    negated = !negated;
    expr = op->getSubExpr();
  }
  const auto* reference = llvm::dyn_cast<clang::DeclRefExpr>(expr);
  const auto* variable = reference ? llvm::dyn_cast<clang::VarDecl>(reference->getDecl()) : nullptr;
  return variable ? std::optional<Condition>({variable, negated}) : std::nullopt;
}

bool is_read(const FunctionView& view, const clang::DeclRefExpr* use) {
  const auto* cast = llvm::dyn_cast_or_null<clang::ImplicitCastExpr>(view.parent(use));
  return cast && cast->getCastKind() == clang::CK_LValueToRValue;
}

/// One value for the whole call: declared once, and only read.
bool never_changes(const FunctionView& view, const clang::VarDecl* variable) {
  if (!variable->hasLocalStorage() || !variable->getType()->isScalarType() || view.jumps()) return false;
  if (const clang::DeclStmt* declaration = view.declaration(variable)) {
    const FunctionView::Span where = view.span(declaration);
    if (std::any_of(view.repeated().begin(), view.repeated().end(),
                    [&](const FunctionView::Span& loop) { return loop.contains(where); }) ||
        view.lambda_around(declaration))
      return false;
  } else if (!llvm::isa<clang::ParmVarDecl>(variable)) {
    return false;
  }
  const auto& uses = view.uses(variable);
  return std::all_of(uses.begin(), uses.end(),
                     [&](const clang::DeclRefExpr* use) { return is_read(view, use); });
}

std::vector<const clang::VarDecl*> deciders(const FunctionView& view, const clang::CFG& cfg) {
  std::map<const clang::VarDecl*, unsigned> branches;
  std::vector<const clang::VarDecl*> found;  // in the order of the graph
  for (const clang::CFGBlock* block : cfg)
    if (const std::optional<Condition> condition = condition_of(*block))
      if (++branches[condition->variable] == 2) found.push_back(condition->variable);
  found.erase(std::remove_if(found.begin(), found.end(),
                             [&](const clang::VarDecl* variable) { return !never_changes(view, variable); }),
              found.end());
  found.resize(std::min(found.size(), most_deciders));
  return found;
}

}  // namespace

std::vector<DecidedValues> decided_ways(const FunctionView& view, const clang::CFG& cfg) {
  std::vector<DecidedValues> ways(1);
  for (const clang::VarDecl* variable : deciders(view, cfg)) {
    const std::size_t before = ways.size();
    ways.insert(ways.end(), ways.begin(), ways.begin() + static_cast<std::ptrdiff_t>(before));
    for (std::size_t i = 0; i < ways.size(); ++i) ways[i][variable] = i < before;
  }
  return ways;
}

bool may_go(const clang::CFGBlock& block, unsigned successor, const DecidedValues& values) {
  const std::optional<Condition> condition = condition_of(block);
  const auto value = condition ? values.find(condition->variable) : values.end();
  return value == values.end() || (value->second != condition->negated) == (successor == 0);
}

}  // namespace tzc::rewriter
