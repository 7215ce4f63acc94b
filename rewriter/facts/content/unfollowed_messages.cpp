// SPDX-License-Identifier: BSD-3-Clause
#include "facts/content/unfollowed_messages.h"

#include "facts/syntax/ast_walk.h"
#include "facts/syntax/calls.h"
#include "facts/syntax/message_type.h"

namespace tzc::rewriter {
namespace {

/// The operand that an expression only passes on; null: it is something else.
const clang::Expr* passed_on(const clang::Expr* expr) {
  if (const clang::Expr* operand = converted(expr)) return operand;
  if (const auto* op = llvm::dyn_cast<clang::UnaryOperator>(expr)) return op->getSubExpr();
  return nullptr;
}

/// disparity.image -> disparity
const clang::Expr* whole_message(const clang::Expr* expr) {
  const auto* member = llvm::dyn_cast<clang::MemberExpr>(expr->IgnoreParenImpCasts());
  if (!member) return expr;
  const clang::QualType base = member->getBase()->getType();
  return is_message_or_pointer(base) ? whole_message(member->getBase()) : expr;
}

class OtherNameFinder {
 public:
  explicit OtherNameFinder(const Unit& unit) : unit_(unit) {}

  /// Whether something of the package may name the same message as well.
  bool may_have_other_name(const clang::Expr* expr) const {
    expr = expr->IgnoreParens();
    if (expr->isPRValue() && is_stock_or_twin(expr->getType())) return false;  // a message by value
    if (llvm::isa<clang::CXXNewExpr, clang::CXXNullPtrLiteralExpr, clang::GNUNullExpr, clang::IntegerLiteral,
                  clang::CXXDefaultArgExpr, clang::ImplicitValueInitExpr>(expr))
      return false;
    if (const clang::Expr* operand = passed_on(expr)) return may_have_other_name(operand);
    if (const auto* made = llvm::dyn_cast<clang::CXXConstructExpr>(expr)) return any_of(made->arguments());
    if (const auto* list = llvm::dyn_cast<clang::InitListExpr>(expr)) return any_of(list->inits());
    const auto* call = llvm::dyn_cast<clang::CallExpr>(expr);
    return !call || may_return_known(call);
  }

 private:
  template <class Range>
  bool any_of(const Range& parts) const {
    return llvm::any_of(parts, [&](const clang::Expr* part) {
      return message_reached(part->getType()) && may_have_other_name(part);
    });
  }

  /// What another package's function returns is a stock message, and none of those that TZC's calls publish.
  bool may_return_known(const clang::CallExpr* call) const {
    const clang::FunctionDecl* function = call->getDirectCallee();
    if (!function || unit_.declares(function)) return true;
    if (makes_object(call) || unit_.rules.find_ported_function(qualified_name_of(function))) return false;
    if (const auto* method = llvm::dyn_cast<clang::CXXMemberCallExpr>(call)) {
      const clang::CXXMethodDecl* decl = method->getMethodDecl();
      if (decl && unit_.rules.find_method(qualified_name_of(decl->getParent()), decl->getNameAsString(),
                                          written_arguments(call)))
        return false;
      return message_reached(method->getImplicitObjectArgument()->getType()).has_value();
    }
    return any_of(call->arguments());
  }

  const Unit& unit_;
};

}  // namespace

std::string unfollowed_type(const Unit& unit, const MessageParts& parts, const clang::Expr* expr) {
  expr = whole_message(expr);
  const std::optional<MessageType> message = message_reached(expr->getType());
  if (!message || !parts.part_of(expr).empty()) return {};
  return OtherNameFinder(unit).may_have_other_name(expr) ? message->name : std::string();
}

}  // namespace tzc::rewriter
