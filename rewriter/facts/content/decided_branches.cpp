// SPDX-License-Identifier: BSD-3-Clause
#include "facts/content/decided_branches.h"

#include <algorithm>
#include <optional>
#include <set>

#include "facts/syntax/bodies.h"
#include "parse/ast_visitor.h"

namespace tzc::rewriter {
namespace {

/// Each doubles the ways.
constexpr std::size_t most_deciders = 3;

struct Condition {
  const clang::ValueDecl* variable;
  bool negated;
};

/// A variable, or a field of *this; null: something else.
const clang::ValueDecl* named_by(const clang::Expr* expr) {
  if (const auto* reference = llvm::dyn_cast<clang::DeclRefExpr>(expr))
    return llvm::dyn_cast<clang::VarDecl>(reference->getDecl());
  const auto* member = llvm::dyn_cast<clang::MemberExpr>(expr);
  const bool is_own = member && llvm::isa<clang::CXXThisExpr>(member->getBase()->IgnoreParenImpCasts());
  return is_own ? llvm::dyn_cast<clang::FieldDecl>(member->getMemberDecl()) : nullptr;
}

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
  const clang::ValueDecl* variable = named_by(expr);
  return variable ? std::optional<Condition>({variable, negated}) : std::nullopt;
}

/// The variable or field, of whatever object.
const clang::ValueDecl* mentioned(const clang::Expr* use) {
  if (const auto* reference = llvm::dyn_cast<clang::DeclRefExpr>(use)) return reference->getDecl();
  return llvm::cast<clang::MemberExpr>(use)->getMemberDecl();
}

bool is_read(const FunctionView& view, const clang::Expr* use) {
  const auto* cast = llvm::dyn_cast_or_null<clang::ImplicitCastExpr>(view.parent(use));
  return cast && cast->getCastKind() == clang::CK_LValueToRValue;
}

/// Declared once for the whole call.
bool is_declared_once(const FunctionView& view, const clang::VarDecl* variable) {
  const clang::DeclStmt* declaration = view.declaration(variable);
  if (!declaration) return llvm::isa<clang::ParmVarDecl>(variable);
  const FunctionView::Span where = view.span(declaration);
  return !view.lambda_around(declaration) &&
         std::none_of(view.repeated().begin(), view.repeated().end(),
                      [&](const FunctionView::Span& loop) { return loop.contains(where); });
}

/// The function only reads it.
bool never_changes(const FunctionView& view, const clang::ValueDecl* variable) {
  if (!variable->getType()->isScalarType() || view.jumps()) return false;
  const auto* local = llvm::dyn_cast<clang::VarDecl>(variable);
  if (local && (!local->hasLocalStorage() || !is_declared_once(view, local))) return false;
  return std::all_of(view.statements().begin(), view.statements().end(), [&](const clang::Stmt* stmt) {
    const auto* use = llvm::dyn_cast<clang::Expr>(stmt);
    const bool is_use = use && llvm::isa<clang::DeclRefExpr, clang::MemberExpr>(use);
    return !is_use || mentioned(use) != variable || is_read(view, use);
  });
}

/// Looks for code that changes a field of some object: what mentions it other than to read it, in functions of the package that are called,
/// and what those call. Calls that show no body may do anything to it, except those of libraries, which know no field of the package.
class FieldChanges : public AstVisitor {
 public:
  FieldChanges(const Unit& unit, const clang::FieldDecl* field) : unit_(unit), field_(field) {}
  bool found() const { return changes_ || mentions_ > reads_; }

  bool VisitMemberExpr(clang::MemberExpr* member) override {
    mentions_ += member->getMemberDecl() == field_;
    return true;
  }
  bool VisitImplicitCastExpr(clang::ImplicitCastExpr* cast) override {
    const auto* member = llvm::dyn_cast<clang::MemberExpr>(cast->getSubExpr()->IgnoreParens());
    reads_ += cast->getCastKind() == clang::CK_LValueToRValue && member && member->getMemberDecl() == field_;
    return true;
  }
  bool VisitCallExpr(clang::CallExpr* call) override { return follow(call->getDirectCallee()); }
  bool VisitCXXConstructExpr(clang::CXXConstructExpr* construct) override {
    return follow(construct->getConstructor());
  }

 private:
  bool follow(const clang::FunctionDecl* callee) {
    if (!callee) changes_ = true;
    if (!callee || !unit_.declares(callee) || callee->isImplicit()) return !changes_;
    if (!seen_.insert(callee->getCanonicalDecl()).second) return true;
    const clang::FunctionDecl* const shown = shown_body(callee);
    const auto* method = llvm::dyn_cast<clang::CXXMethodDecl>(callee);
    changes_ = changes_ || !shown || (method && method->isVirtual());
    return !changes_ && TraverseStmt(shown->getBody());
  }

  const Unit& unit_;
  const clang::FieldDecl* const field_;
  std::set<const clang::FunctionDecl*> seen_;
  unsigned mentions_ = 0, reads_ = 0;
  bool changes_ = false;
};

bool calls_change(const Unit& unit, const FunctionView& view, const clang::ValueDecl* variable) {
  const auto* const field = llvm::dyn_cast<clang::FieldDecl>(variable);
  if (!field) return false;
  FieldChanges changes(unit, field);
  changes.TraverseStmt(view.function()->getBody());
  return changes.found();
}

std::vector<const clang::ValueDecl*> deciders(const Unit& unit, const FunctionView& view,
                                              const clang::CFG& cfg) {
  std::map<const clang::ValueDecl*, unsigned> branches;
  std::vector<const clang::ValueDecl*> found;  // in the order of the graph
  for (const clang::CFGBlock* block : cfg)
    if (const std::optional<Condition> condition = condition_of(*block))
      if (++branches[condition->variable] == 2) found.push_back(condition->variable);
  found.erase(std::remove_if(found.begin(), found.end(),
                             [&](const clang::ValueDecl* variable) {
                               return !never_changes(view, variable) || calls_change(unit, view, variable);
                             }),
              found.end());
  found.resize(std::min(found.size(), most_deciders));
  return found;
}

}  // namespace

std::vector<DecidedValues> decided_ways(const Unit& unit, const FunctionView& view, const clang::CFG& cfg) {
  std::vector<DecidedValues> ways(1);
  for (const clang::ValueDecl* variable : deciders(unit, view, cfg)) {
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
