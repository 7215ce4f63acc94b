// SPDX-License-Identifier: BSD-3-Clause
#include "facts/content/copy_homes.h"

#include "facts/syntax/calls.h"
#include "facts/syntax/message_type.h"
#include "model/content_flow.h"

namespace tzc::rewriter {
namespace {

/// What an object that is made goes through on its way into another one, or is made into one by.
bool leads_on(const Unit& unit, const clang::Stmt* around) {
  if (const auto* made = llvm::dyn_cast<clang::CXXConstructExpr>(around))
    return !unit.declares(made->getConstructor()) || made->getConstructor()->isCopyOrMoveConstructor();
  return llvm::isa<clang::CastExpr, clang::FullExpr, clang::MaterializeTemporaryExpr,
                   clang::CXXBindTemporaryExpr, clang::ParenExpr, clang::CXXStdInitializerListExpr,
                   clang::InitListExpr, clang::ConditionalOperator>(around);
}

/// F{image, 1}: the member that an element of the list initializes. Null: it is no list of a class of the package.
const clang::FieldDecl* member_of(const Unit& unit, const clang::InitListExpr* list,
                                  const clang::Stmt* element) {
  const clang::CXXRecordDecl* record = list->getType()->getAsCXXRecordDecl();
  if (!record || record->isUnion() || !unit.source.in_package(record->getLocation())) return nullptr;
  unsigned index = record->getNumBases();
  for (const clang::FieldDecl* field : record->fields()) {
    if (field->isBitField() && !field->getIdentifier()) continue;
    if (index < list->getNumInits() && list->getInit(index) == element) return field;
    ++index;
  }
  return nullptr;
}

const clang::VarDecl* variable_of(const clang::DeclStmt* statement, const clang::Stmt* value) {
  for (const clang::Decl* decl : statement->decls())
    if (const auto* variable = llvm::dyn_cast<clang::VarDecl>(decl); variable && variable->getInit() == value)
      return variable;
  return nullptr;
}

bool is_map(clang::QualType type) {
  const clang::CXXRecordDecl* record = type->getAsCXXRecordDecl();
  return record && record->getIdentifier() &&
         (record->getName() == "map" || record->getName() == "unordered_map");
}

}  // namespace

CopyHomes::CopyHomes(const Unit& unit, const FunctionView& view)
    : unit_(unit), view_(view), parts_(unit, view), holders_(unit, view) {}

/// A member of an object on the heap, or in a container: of a variable's, the flow of its content tells.
CopyHome CopyHomes::of(const clang::Expr* made) const {
  const clang::FieldDecl* member = nullptr;
  const clang::Stmt* inner = made;
  for (const clang::Stmt* around = view_.parent(inner); around;
       inner = around, around = view_.parent(around)) {
    if (const auto* list = llvm::dyn_cast<clang::InitListExpr>(around); list && !member)
      member = member_of(unit_, list, inner);
    const auto* call = llvm::dyn_cast<clang::CallExpr>(around);
    const auto* fresh = llvm::dyn_cast<clang::CXXNewExpr>(around);
    if (fresh && is_stock_or_twin(fresh->getAllocatedType())) return {};  // a message of its own
    const bool is_made = (call && makes_object(call)) || fresh;
    if (is_made && member) return of_member(member);
    if (const auto* statement = llvm::dyn_cast<clang::DeclStmt>(around))
      return member ? CopyHome() : of_declaration(statement, inner);
    if (llvm::isa<clang::ReturnStmt>(around)) return member ? of_member(member) : of_result(around);
    if (call && !is_made) return member ? of_member(member) : of_call(call, inner);
    if (!is_made && !leads_on(unit_, around)) return {};
  }
  return of_initializer(inner);
}

/// A message of its own has an allocation site, or a reason why it has none.
CopyHome CopyHomes::of_declaration(const clang::DeclStmt* statement, const clang::Stmt* value) const {
  const clang::VarDecl* variable = variable_of(statement, value);
  if (!variable || (!variable->getType()->isReferenceType() && is_stock_or_twin(variable->getType())))
    return {};
  return {holders_.of_name(variable), "copied into '" + variable->getNameAsString() + "'"};
}

/// frames.push_back(Image(image)), latest = Image(image). What a function of the package is given, given_messages.cpp tells.
CopyHome CopyHomes::of_call(const clang::CallExpr* call, const clang::Stmt* argument) const {
  if (!call->getDirectCallee() || unit_.declares(call->getDirectCallee())) return {};
  const auto* op = llvm::dyn_cast<clang::CXXOperatorCallExpr>(call);
  if (op && op->getOperator() == clang::OO_Equal && op->getArg(1) == argument)
    return {holders_.of(op->getArg(0)), "moved to '" + unit_.text(op->getArg(0)) + "'"};
  const auto* method = llvm::dyn_cast<clang::CXXMemberCallExpr>(call);
  if (!method || !method->getMethodDecl() || !holds_messages(method->getImplicitObjectArgument()->getType()))
    return {};
  return {holders_.of(method->getImplicitObjectArgument()),
          "stored by '" + method->getMethodDecl()->getNameAsString() + "'"};
}

/// return {image, 1}. What a closure returns has no name here; of a message itself, the flow of its content tells.
CopyHome CopyHomes::of_result(const clang::Stmt* statement) const {
  if (view_.lambda_around(statement) || returns_message(view_.function())) return {};
  return {result_root(usr_of(pattern_of(view_.function()))),
          "returned from '" + view_.function()->getNameAsString() + "'"};
}

CopyHome CopyHomes::of_member(const clang::FieldDecl* field) const {
  return {root_in(usr_of(pattern_of(view_.function())), parts_.root_of(field)),
          "copied into '" + field->getNameAsString() + "'"};
}

/// A constructor's, of a member.
CopyHome CopyHomes::of_initializer(const clang::Stmt* value) const {
  const clang::CXXCtorInitializer* initializer = view_.initializer(value);
  const clang::FieldDecl* field = initializer ? initializer->getAnyMember() : nullptr;
  return field ? of_member(field) : CopyHome();
}

/// A loop may come to the use again and find what it put there.
bool CopyHomes::may_last(const clang::VarDecl* variable, const clang::Stmt* use) const {
  const clang::DeclStmt* declaration = view_.declaration(variable);
  return !declaration || view_.jumps() || view_.lambda_around(declaration) != view_.lambda_around(use) ||
         llvm::any_of(view_.repeated(), [&](const FunctionView::Span& loop) {
           return loop.contains(view_.span(use)) && !loop.contains(view_.span(declaration));
         });
}

bool CopyHomes::is_new_entry(const clang::Expr* expr) const {
  const auto* op = llvm::dyn_cast<clang::CXXOperatorCallExpr>(expr->IgnoreParens());
  if (!op || op->getOperator() != clang::OO_Subscript || !is_map(op->getArg(0)->getType())) return false;
  const auto* name = llvm::dyn_cast<clang::DeclRefExpr>(op->getArg(0)->IgnoreParenImpCasts());
  const auto* variable = name ? llvm::dyn_cast<clang::VarDecl>(name->getDecl()) : nullptr;
  return variable && variable->isLocalVarDecl() && variable->hasLocalStorage() &&
         !variable->getType()->isReferenceType() && !may_last(variable, op);
}

}  // namespace tzc::rewriter
