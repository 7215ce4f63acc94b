// SPDX-License-Identifier: BSD-3-Clause
// The steps of a reference to data through statements and expressions. Calls are in escape_calls.cpp.
#include "facts/escape/escape_climb.h"

#include <clang/AST/DeclTemplate.h>
#include <clang/AST/StmtCXX.h>

#include "facts/flow/stock_vectors.h"
#include "facts/syntax/ast_walk.h"
#include "facts/syntax/known_functions.h"

namespace tzc::rewriter {
namespace {

bool may_hold(clang::QualType type, unsigned depth);

bool record_may_hold(const clang::CXXRecordDecl* record, unsigned depth) {
  if (!record || !record->hasDefinition()) return true;
  if (record->isUnion() || record->isLambda()) return true;
  return llvm::any_of(record->fields(),
                      [&](const clang::FieldDecl* f) { return may_hold(f->getType(), depth + 1); }) ||
         llvm::any_of(record->bases(), [&](const clang::CXXBaseSpecifier& base) {
           return may_hold(base.getType(), depth + 1);
         });
}

bool may_hold(clang::QualType type, unsigned depth) {
  if (type.isNull() || depth > 8) return true;
  type = type.getCanonicalType();
  if (type->isVoidType() || type->isArithmeticType() || type->isEnumeralType()) return false;
  if (const auto* array = type->getAsArrayTypeUnsafe()) return may_hold(array->getElementType(), depth + 1);
  const clang::CXXRecordDecl* record = type->getAsCXXRecordDecl();
  if (!record) return true;
  const auto* made = llvm::dyn_cast<clang::ClassTemplateSpecializationDecl>(record);
  if (made && is_owner_class(qualified_name_of(record)) && made->getTemplateArgs().size() > 0 &&
      made->getTemplateArgs()[0].getKind() == clang::TemplateArgument::Type)
    return may_hold(made->getTemplateArgs()[0].getAsType(), depth + 1);
  return record_may_hold(record, depth);
}

const clang::VarDecl* initialised_by(const clang::DeclStmt* declaration, const clang::Expr* value) {
  for (const clang::Decl* decl : declaration->decls())
    if (const auto* variable = llvm::dyn_cast<clang::VarDecl>(decl))
      if (variable->getInit() == value) return variable;
  return nullptr;
}

/// A statement that throws the value of an expression away, or only asks whether it is true.
bool discards(const clang::Stmt* stmt) {
  return llvm::isa<clang::CompoundStmt, clang::IfStmt, clang::ForStmt, clang::WhileStmt, clang::DoStmt,
                   clang::SwitchStmt, clang::SwitchCase, clang::LabelStmt, clang::AttributedStmt,
                   clang::CXXForRangeStmt>(stmt);
}

}  // namespace

bool may_hold_pointer(clang::QualType type) {
  return may_hold(type, 0);
}

bool is_view(clang::QualType type) {
  const clang::CXXRecordDecl* record = type.getNonReferenceType().getCanonicalType()->getAsCXXRecordDecl();
  return record && is_view_class(qualified_name_of(record));
}

Referring climb_reference(EscapeContext& context, const FunctionView& view, EscapeAnalysis& analysis,
                          const Referring& from) {
  return Climber(context, view, analysis, from).run();
}

/// The port puts a tzc::Array where the source has a std::vector, so whoever gets at it must name it by a type that follows, or that the
/// compiler refuses. That holds for each step, whatever expression it is: while the climb is at an array, pointers and references to it,
/// each type on the way is an array's. What is none (void*, const void*, a base, another object's pointer) may be made a std::vector
/// again where no compiler sees it. Casts that keep the type, but write it out, are in into_explicit_cast().
bool Climber::step() {
  const bool was_named = at_.how == Reference::array && names_array(at_.expr->getType());
  if (!step_up()) return false;
  if (was_named && at_.how == Reference::array && !names_array(at_.expr->getType()))
    escape_as(at_.expr->getType());
  return true;
}

bool Climber::step_up() {
  const clang::Stmt* parent = view_.parent(at_.expr);
  if (!parent) return into_root();
  const auto* expr = llvm::dyn_cast<clang::Expr>(parent);
  return expr ? into_expression(expr) : into_statement(parent);
}

bool Climber::is_value_of_statements(const clang::Stmt* value) const {
  return rewriter::is_value_of_statements(value, [&](const clang::Stmt* of) { return view_.parent(of); });
}

/// A member's initializer.
bool Climber::into_root() {
  const clang::CXXCtorInitializer* initializer = view_.initializer(at_.expr);
  const clang::FieldDecl* field = initializer ? initializer->getAnyMember() : nullptr;
  if (field && !field->getType()->isReferenceType() && !may_hold_pointer(field->getType())) return done();
  return escape("is kept in a member");
}

bool Climber::into_statement(const clang::Stmt* parent) {
  if (const auto* declaration = llvm::dyn_cast<clang::DeclStmt>(parent)) return into_declaration(declaration);
  if (is_value_of_statements(at_.expr)) return escape("is the value of a statement expression");
  if (discards(parent)) return done();
  if (const auto* stmt = llvm::dyn_cast<clang::ReturnStmt>(parent)) return into_return(stmt);
  return escape("is used in a way that is not understood");
}

bool Climber::into_return(const clang::ReturnStmt* stmt) {
  const clang::LambdaExpr* lambda = view_.lambda_around(stmt);
  const clang::FunctionDecl* function = lambda ? lambda->getCallOperator() : view_.function();
  const bool is_value = at_.expr->isPRValue() && !may_hold_pointer(at_.expr->getType());
  return is_value && !gives_type(function->getReturnType()) ? done() : escape("is returned");
}

bool Climber::into_declaration(const clang::DeclStmt* declaration) {
  const clang::VarDecl* variable = initialised_by(declaration, at_.expr);
  if (!variable || llvm::isa<clang::DecompositionDecl>(variable))
    return escape("is bound to several names", false);
  const clang::QualType type = variable->getType();
  if (!type->isReferenceType() && !may_hold_pointer(type) && !gives_type(type)) return done();
  if (!variable->isLocalVarDecl() || variable->isStaticLocal())
    return escape("is kept in '" + variable->getNameAsString() + "'");
  // Initialised directly, a reference to a const std::vector binds, with Clang, to a copy, as an explicit conversion makes one. With '='
  // it takes no explicit conversion: the compiler refuses it.
  if (at_.how == Reference::array && type->isReferenceType() &&
      variable->getInitStyle() != clang::VarDecl::CInit &&
      is_pointee_written_out(context_.unit.ast(), type) && !is_renamed(variable))
    escape("is bound to '" + variable->getNameAsString() + "', a reference to a std::vector", false);
  return hold(variable);
}

/// Whether the port writes auto for the type of a variable that the array initialises.
bool Climber::is_renamed(const clang::VarDecl* variable) const {
  const auto* array = llvm::dyn_cast<clang::MemberExpr>(variable->getInit()->IgnoreParenImpCasts());
  return array && is_data_array(array->getType()) && !changes_for_stock_vector(context_.unit, array).empty();
}

bool Climber::into_expression(const clang::Expr* parent) {
  if (parent->isTypeDependent()) return escape("is used by a generic lambda", false);
  if (const auto* cast = llvm::dyn_cast<clang::ImplicitCastExpr>(parent)) return into_implicit_cast(cast);
  if (llvm::isa<clang::ParenExpr, clang::FullExpr, clang::MaterializeTemporaryExpr,
                clang::CXXBindTemporaryExpr, clang::SubstNonTypeTemplateParmExpr>(parent))
    return go_on(parent);
  if (const auto* member = llvm::dyn_cast<clang::MemberExpr>(parent)) return into_member(member);
  if (const auto* op = llvm::dyn_cast<clang::CXXOperatorCallExpr>(parent)) return into_operator(op);
  if (const auto* call = llvm::dyn_cast<clang::CallExpr>(parent)) return into_call(call);
  if (const auto* made = llvm::dyn_cast<clang::CXXConstructExpr>(parent)) return into_construction(made);
  if (const auto* cast = llvm::dyn_cast<clang::ExplicitCastExpr>(parent)) return into_explicit_cast(cast);
  if (const auto* op = llvm::dyn_cast<clang::UnaryOperator>(parent)) return into_unary(op);
  if (const auto* op = llvm::dyn_cast<clang::BinaryOperator>(parent)) return into_binary(op);
  if (llvm::isa<clang::ArraySubscriptExpr>(parent)) return go_on(parent);
  if (const auto* choice = llvm::dyn_cast<clang::AbstractConditionalOperator>(parent))
    return choice->getCond() == at_.expr ? done() : go_on(choice);
  if (const auto* list = llvm::dyn_cast<clang::InitListExpr>(parent)) return into_list(list);
  if (const auto* lambda = llvm::dyn_cast<clang::LambdaExpr>(parent)) return into_lambda(lambda);
  if (llvm::isa<clang::UnaryExprOrTypeTraitExpr, clang::CXXTypeidExpr>(parent)) return into_type_question();
  if (llvm::isa<clang::CXXNewExpr>(parent) && is_copy()) return done();
  if (llvm::isa<clang::CXXNoexceptExpr>(parent)) return done();
  return escape("is used in a way that is not understood");
}

/// sizeof, typeid: the answer changes with the array's type. What else they may be asked about: type_questions.h.
bool Climber::into_type_question() {
  return at_.how == Reference::array ? escape("has a type that the program asks for", false) : done();
}

bool Climber::into_implicit_cast(const clang::ImplicitCastExpr* cast) {
  if (cast->getCastKind() == clang::CK_PointerToBoolean) return done();
  const bool is_value =
      at_.how != Reference::array && cast->isPRValue() && !may_hold_pointer(cast->getType());
  if (!is_value) return go_on(cast);
  switch (cast->getCastKind()) {
    case clang::CK_LValueToRValue:
    case clang::CK_PointerToBoolean:
    case clang::CK_UserDefinedConversion:
    case clang::CK_ToVoid:
      return done();
    default:
      return escape("is converted to '" + cast->getType().getAsString() + "'");
  }
}

bool Climber::into_explicit_cast(const clang::ExplicitCastExpr* cast) {
  const clang::QualType type = cast->getType();
  if (is_copy() && !gives_type(cast->getTypeAsWritten())) return done();
  if (cast->getCastKind() == clang::CK_PointerToIntegral)
    analysis_.cast_const_away(at_);  // a number has none
  if (removes_const(cast)) {
    analysis_.cast_const_away(at_);
    // Const access may have given an address in memory that subscribers share.
    if (at_.read_only) return escape("loses its const", false);
  }
  if (type->isVoidType() || type->isBooleanType()) return done();
  // The cast stays one to std::vector where the array is none: a reinterpret_cast, or, with Clang, a reference to a copy.
  if (at_.how == Reference::array && is_pointee_written_out(context_.unit.ast(), cast->getTypeAsWritten()) &&
      names_array(cast->getTypeAsWritten()))
    escape("is cast to '" + cast->getTypeAsWritten().getAsString() + "', which its array is not in the port",
           false);
  if (type->isAnyPointerType() || cast->isGLValue() || type->isRecordType()) return go_on(cast);
  return escape("is cast to '" + type.getAsString() + "'");
}

/// By its answer: what no pointer can be kept in ends the search, whatever the operator is.
bool Climber::into_unary(const clang::UnaryOperator* op) {
  return op->isPRValue() && !may_hold_pointer(op->getType()) ? done() : go_on(op);
}

namespace {

/// Whether the other side of a subtraction of pointers may lie in the same array: it begins in one of a message, or is a local variable. The
/// language knows no other distances, but programs keep pointers as one: `p - reinterpret_cast<char*>(this)`.
bool begins_in_an_array(const clang::Expr* pointer) {
  pointer = pointer->IgnoreParenCasts();
  if (const auto* op = llvm::dyn_cast<clang::UnaryOperator>(pointer))
    return begins_in_an_array(op->getSubExpr());
  if (const auto* op = llvm::dyn_cast<clang::BinaryOperator>(pointer))
    return begins_in_an_array(op->getLHS()->getType()->isIntegerType() ? op->getRHS() : op->getLHS());
  if (const auto* element = llvm::dyn_cast<clang::ArraySubscriptExpr>(pointer))
    return begins_in_an_array(element->getBase());
  if (const auto* call = llvm::dyn_cast<clang::CXXMemberCallExpr>(pointer))
    return begins_in_an_array(call->getImplicitObjectArgument());
  if (const auto* call = llvm::dyn_cast<clang::CXXOperatorCallExpr>(pointer))
    return begins_in_an_array(call->getArg(0));
  if (const auto* member = llvm::dyn_cast<clang::MemberExpr>(pointer))
    return is_data_array(member->getType());
  const auto* reference = llvm::dyn_cast<clang::DeclRefExpr>(pointer);
  const auto* variable = reference ? llvm::dyn_cast<clang::VarDecl>(reference->getDecl()) : nullptr;
  return variable && variable->isLocalVarDeclOrParm() && !variable->isStaticLocal();
}

}  // namespace

bool Climber::into_binary(const clang::BinaryOperator* op) {
  const clang::Expr* other = op->getLHS() == at_.expr ? op->getRHS() : op->getLHS();
  if (op->getOpcode() == clang::BO_Sub && other->getType()->isPointerType() && !begins_in_an_array(other))
    return escape("becomes a distance from something else");
  if (op->getOpcode() == clang::BO_Comma) return op->getRHS() == at_.expr ? go_on(op) : done();
  if (op->getOpcode() == clang::BO_Assign && op->getRHS() == at_.expr) return into_assignment(op->getLHS());
  if (op->isAssignmentOp()) return op->getLHS() == at_.expr ? go_on(op) : done();
  if (op->isPtrMemOp()) return escape("is used through a pointer to member");
  return may_hold_pointer(op->getType()) ? go_on(op) : done();
}

bool ClimbState::into_assignment(const clang::Expr* target) {
  if (at_.expr->isPRValue() && !may_hold_pointer(at_.expr->getType())) return done();
  const auto* reference = llvm::dyn_cast<clang::DeclRefExpr>(target->IgnoreParenImpCasts());
  const auto* variable = reference ? llvm::dyn_cast<clang::VarDecl>(reference->getDecl()) : nullptr;
  const bool is_own = variable && variable->isLocalVarDeclOrParm() && !variable->isStaticLocal() &&
                      !variable->getType()->isReferenceType() &&
                      !reference->refersToEnclosingVariableOrCapture();
  return is_own ? hold(variable)
                : escape("is kept in '" + context_.unit.source.text(target->getSourceRange()) + "'");
}

/// A list as an initializer of one pointer is that pointer; elsewhere it makes a new object.
bool Climber::into_list(const clang::InitListExpr* list) {
  if (is_copy()) return done();
  if (list->isGLValue() || list->getType()->isAnyPointerType() || is_view(list->getType()))
    return go_on(list);
  return may_hold_pointer(list->getType()) ? escape("becomes part of an aggregate") : done();
}

/// A closure that is used up on the spot keeps nothing; its body is part of the function.
bool Climber::is_used_up(const clang::LambdaExpr* lambda) const {
  const clang::Stmt* around = view_.parent(lambda);
  while (is_wrapping(around)) around = view_.parent(around);
  if (const auto* copy = llvm::dyn_cast_or_null<clang::CXXConstructExpr>(around))
    if (copy->getConstructor()->getParent() == lambda->getLambdaClass()) around = view_.parent(copy);
  const auto* call = llvm::dyn_cast_or_null<clang::CallExpr>(around);
  const clang::FunctionDecl* callee = call ? call->getDirectCallee() : nullptr;
  if (!callee) return false;
  if (callee == lambda->getCallOperator()) return true;
  if (context_.keeping_of(callee, at_.messages) == Keeping::unknown) return false;
  // std::for_each returns the closure.
  const clang::QualType result = call->getType().getNonReferenceType().getCanonicalType();
  if (!result->isRecordType() || is_view(result) || !may_hold_pointer(result)) return true;
  const clang::Stmt* value = call;
  while (llvm::isa_and_nonnull<clang::FullExpr, clang::CXXBindTemporaryExpr>(view_.parent(value)))
    value = view_.parent(value);
  const clang::Stmt* user = view_.parent(value);
  return user && discards(user) && !is_value_of_statements(value);
}

/// The variable of the closure that an expression initialises; null: it is captured under its own name.
const clang::VarDecl* Climber::capture_of(const clang::LambdaExpr* lambda) const {
  for (const clang::LambdaCapture& capture : lambda->captures()) {
    const auto* variable =
        capture.capturesVariable() ? llvm::dyn_cast<clang::VarDecl>(capture.getCapturedVar()) : nullptr;
    if (variable && variable->isInitCapture() && variable->getInit() == at_.expr) return variable;
  }
  return nullptr;
}

bool Climber::into_lambda(const clang::LambdaExpr* lambda) {
  const clang::VarDecl* variable = capture_of(lambda);
  if (variable && is_copy()) return hold(variable);
  return !variable && is_used_up(lambda) ? done() : escape("is held by a closure");
}

}  // namespace tzc::rewriter
