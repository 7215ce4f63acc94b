// SPDX-License-Identifier: BSD-3-Clause
#include "facts/flow/deleters.h"

#include <clang/AST/DeclTemplate.h>
#include <llvm/ADT/STLExtras.h>

#include "facts/syntax/ast_walk.h"
#include "facts/syntax/calls.h"
#include "facts/syntax/message_type.h"

namespace tzc::rewriter {
namespace {

bool is_shared_pointer(clang::QualType type) {
  const clang::CXXRecordDecl* record = type.getNonReferenceType()->getAsCXXRecordDecl();
  const std::string name = record ? qualified_name_of(record) : "";
  return name == "boost::shared_ptr" || name == "std::shared_ptr";
}

bool leads_to_message(clang::QualType type) {
  const clang::QualType pointee = pointee_of(type);
  return type.getNonReferenceType()->isPointerType() && message_of(pointee).has_value() &&
         !pointee->isPointerType();
}

/// The only one that a class declares; null: it has none, or several. Nor does it count where the class has a destructor of its own, or
/// captures something that has: that shows when the pointer lets go, too.
const clang::FunctionDecl* only_call_operator(const clang::CXXRecordDecl* record, bool& is_generic) {
  const clang::FunctionDecl* only = nullptr;
  if (!record || !record->hasDefinition() || record->getNumBases() != 0 || !record->hasTrivialDestructor())
    return nullptr;
  for (const clang::Decl* decl : record->decls()) {
    const auto* pattern = llvm::dyn_cast<clang::FunctionTemplateDecl>(decl);
    const auto* method = llvm::dyn_cast<clang::CXXMethodDecl>(pattern ? pattern->getTemplatedDecl() : decl);
    if (!method || method->getDeclName().getCXXOverloadedOperator() != clang::OO_Call) continue;
    if (only) return nullptr;
    only = method;
    is_generic = pattern != nullptr;
  }
  return only;
}

/// release, &release
const clang::FunctionDecl* function_named(const clang::Expr* expr) {
  expr = expr->IgnoreParenImpCasts();
  const auto* op = llvm::dyn_cast<clang::UnaryOperator>(expr);
  if (op && op->getOpcode() == clang::UO_AddrOf) expr = op->getSubExpr()->IgnoreParenImpCasts();
  const auto* name = llvm::dyn_cast<clang::DeclRefExpr>(expr);
  return name ? llvm::dyn_cast<clang::FunctionDecl>(name->getDecl()) : nullptr;
}

Deleter deleter_among(const Unit& unit, llvm::ArrayRef<const clang::Expr*> arguments) {
  if (arguments.size() < 2 || !leads_to_message(arguments[0]->getType())) return {};
  Deleter deleter{arguments[1]};
  const clang::CXXRecordDecl* record = arguments[1]->getType().getNonReferenceType()->getAsCXXRecordDecl();
  const clang::FunctionDecl* function =
      record ? only_call_operator(record, deleter.is_generic) : function_named(arguments[1]);
  if (function && function->getNumParams() == 1 && unit.declares(function) &&
      !function->isTemplateInstantiation() &&
      (deleter.is_generic || leads_to_message(function->getParamDecl(0)->getType())))
    deleter.function = function;
  return deleter;
}

/// Looks at all that a deleter's body executes.
class Deletion {
 public:
  explicit Deletion(const clang::ParmVarDecl* message) : message_(message) {}

  bool is_all(const clang::Stmt* statement) {
    if (const auto* block = llvm::dyn_cast<clang::CompoundStmt>(statement))
      return llvm::all_of(block->body(), [&](const clang::Stmt* part) { return is_all(part); });
    if (const auto* branch = llvm::dyn_cast<clang::IfStmt>(statement))
      return !branch->getInit() && !branch->getConditionVariable() && !branch->getElse() &&
             tests(branch->getCond()) && is_all(branch->getThen());
    const auto* end = llvm::dyn_cast<clang::CXXDeleteExpr>(statement);
    deletes = deletes || end;
    return end && !end->isArrayForm() && !end->isGlobalDelete() && names(end->getArgument());
  }
  bool deletes = false;

 private:
  bool names(const clang::Expr* expr) const {
    const auto* name = llvm::dyn_cast<clang::DeclRefExpr>(expr->IgnoreParenImpCasts());
    return name && name->getDecl() == message_;
  }
  bool tests(const clang::Expr* condition) const {
    const auto* op = llvm::dyn_cast<clang::BinaryOperator>(condition->IgnoreParenImpCasts());
    if (!op) return names(condition);
    return op->getOpcode() == clang::BO_NE && names(op->getLHS()) &&
           llvm::isa<clang::CXXNullPtrLiteralExpr, clang::GNUNullExpr>(op->getRHS()->IgnoreParenImpCasts());
  }

  const clang::ParmVarDecl* const message_;
};

}  // namespace

Deleter deleter_of(const Unit& unit, const clang::CXXConstructExpr* pointer) {
  if (!is_shared_pointer(pointer->getType()) || unit.declares(pointer->getConstructor())) return {};
  return deleter_among(unit, {pointer->getArgs(), pointer->getNumArgs()});
}

Deleter deleter_of(const Unit& unit, const clang::CXXMemberCallExpr* reset) {
  const clang::CXXMethodDecl* method = reset->getMethodDecl();
  if (!method || !method->getIdentifier() || method->getName() != "reset" ||
      !is_shared_pointer(unit.ast().getRecordType(method->getParent())))
    return {};
  return deleter_among(unit, {reset->getArgs(), reset->getNumArgs()});
}

bool only_deletes(const Deleter& deleter) {
  const clang::FunctionDecl* definition = nullptr;
  const clang::Stmt* body = deleter.function ? deleter.function->getBody(definition) : nullptr;
  if (!body || !llvm::isa<clang::CompoundStmt>(body) || definition->getNumParams() != 1) return false;
  Deletion deletion(definition->getParamDecl(0));
  return deletion.is_all(body) && deletion.deletes;
}

bool has_generic_deleter(const Unit& unit, const clang::Expr* call) {
  const auto* construct = llvm::dyn_cast<clang::CXXConstructExpr>(call);
  const auto* reset = llvm::dyn_cast<clang::CXXMemberCallExpr>(call);
  const Deleter deleter = construct ? deleter_of(unit, construct)
                          : reset   ? deleter_of(unit, reset)
                                    : Deleter();
  return deleter.is_generic && only_deletes(deleter);
}

bool is_named_as_deleter(const Unit& unit, const clang::Expr* name) {
  const auto is_it = [&](const Deleter& deleter, const clang::Expr* given) {
    return deleter.given && deleter.given == given && only_deletes(deleter);
  };
  const clang::Expr* given = name;
  for (const clang::DynTypedNode& node : ancestors(unit.ast(), *name)) {
    const auto* expr = node.get<clang::Expr>();
    if (!expr) return false;
    if (const auto* call = llvm::dyn_cast<clang::CXXMemberCallExpr>(expr))
      return is_it(deleter_of(unit, call), given);
    const auto* construct = llvm::dyn_cast<clang::CXXConstructExpr>(expr);
    if (construct && is_shared_pointer(construct->getType()))
      return is_it(deleter_of(unit, construct), given);
    const bool is_copy = construct && construct->getConstructor()->isCopyOrMoveConstructor();
    const auto* op = llvm::dyn_cast<clang::UnaryOperator>(expr);
    if (!is_copy && !is_implicit_wrapper(expr) && !llvm::isa<clang::ParenExpr>(expr) &&
        !(op && op->getOpcode() == clang::UO_AddrOf))
      return false;
    given = expr;
  }
  return false;
}

}  // namespace tzc::rewriter
