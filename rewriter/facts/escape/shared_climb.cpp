// SPDX-License-Identifier: BSD-3-Clause
#include "facts/escape/shared_climb.h"

#include <clang/AST/StmtCXX.h>

#include "facts/escape/shared_types.h"
#include "facts/syntax/ast_walk.h"
#include "facts/syntax/bodies.h"
#include "facts/syntax/bound_calls.h"
#include "facts/syntax/calls.h"

namespace tzc::rewriter {
namespace {

unsigned index_of(llvm::ArrayRef<const clang::Expr*> arguments, const clang::Expr* argument) {
  return static_cast<unsigned>(llvm::find(arguments, argument) - arguments.begin());
}

/// mat.forEach<T>([](const T& element, ...) {...})
bool takes_const_elements(const clang::CXXMemberCallExpr* call) {
  const clang::Expr* given =
      call->getNumArgs() > 0 ? call->getArg(0)->IgnoreUnlessSpelledInSource() : nullptr;
  const auto* lambda = llvm::dyn_cast_or_null<clang::LambdaExpr>(given);
  if (!lambda || lambda->getCallOperator()->getNumParams() == 0) return false;
  const clang::QualType element = lambda->getCallOperator()->getParamDecl(0)->getType();
  return !element->isReferenceType() || element.getNonReferenceType().isConstQualified();
}

/// The value of `expr`, if it still leads to the elements; null: it does not.
const clang::Expr* go_on(const clang::Expr* expr) {
  return expr->isGLValue() || leads_to_elements(expr->getType()) ? expr : nullptr;
}

}  // namespace

SharedClimb::Next SharedClimb::next() {
  const clang::Stmt* parent = view_.parent(at_);
  if (!parent) {
    const clang::CXXCtorInitializer* initializer = view_.initializer(at_);
    if (initializer && initializer->getMember()) elements_.hold(initializer->getMember());
    return done();
  }
  const auto* expr = llvm::dyn_cast<clang::Expr>(parent);
  return expr ? into_expression(expr) : into_statement(parent);
}

SharedClimb::Next SharedClimb::into_statement(const clang::Stmt* parent) {
  if (const auto* declaration = llvm::dyn_cast<clang::DeclStmt>(parent))
    for (const clang::Decl* decl : declaration->decls())
      if (const auto* variable = llvm::dyn_cast<clang::VarDecl>(decl); variable && variable->getInit() == at_)
        return into_variable(variable);
  const auto parent_of = [&](const clang::Stmt* of) { return view_.parent(of); };
  if (is_value_of_statements(at_, parent_of) && go_on(at_)) return write(at_);  // it is not followed
  if (!llvm::isa<clang::ReturnStmt>(parent)) return done();
  const clang::LambdaExpr* lambda = view_.lambda_around(parent);
  elements_.hold(lambda ? lambda->getCallOperator() : view_.function());
  return done();
}

SharedClimb::Next SharedClimb::into_variable(const clang::VarDecl* variable) {
  elements_.hold(variable);
  if (const auto* parts = llvm::dyn_cast<clang::DecompositionDecl>(variable))
    for (const clang::BindingDecl* part : parts->bindings())
      if (leads_to_elements(part->getType())) elements_.hold(part);
  return done();
}

SharedClimb::Next SharedClimb::into_capture(const clang::LambdaExpr* lambda) {
  for (const clang::LambdaCapture& capture : lambda->captures()) {
    const clang::ValueDecl* captured = capture.capturesVariable() ? capture.getCapturedVar() : nullptr;
    const auto* variable = llvm::dyn_cast_or_null<clang::VarDecl>(captured);
    if (variable && variable->isInitCapture() && variable->getInit() == at_) elements_.hold(variable);
  }
  return done();
}

SharedClimb::Next SharedClimb::into_binary(const clang::BinaryOperator* op) {
  if (!op->isAssignmentOp()) {
    const bool is_value = op->isAdditiveOp() || (op->getOpcode() == clang::BO_Comma && op->getRHS() == at_);
    return is_value ? go_on(op) : done();
  }
  if (op->getLHS() == at_) return at_->getType()->isAnyPointerType() ? go_on(op) : write(at_);
  if (leads_to_elements(at_->getType())) elements_.hold_object(op->getLHS());
  return done();
}

/// target = value, target += value
SharedClimb::Next SharedClimb::into_assignment(const clang::CXXOperatorCallExpr* call) {
  const clang::Expr* value = call->getArg(1);
  const bool is_plain = call->getOperator() == clang::OO_Equal;
  if (call->getArg(0) == at_) {
    const bool is_handle = leads_to_elements(at_->getType());
    const bool lets_go = is_handle && (!is_mat(at_->getType()) || leads_to_elements(value->getType()));
    return is_plain && lets_go ? go_on(call) : write(at_);
  }
  if (is_plain && leads_to_elements(at_->getType())) elements_.hold_object(call->getArg(0));
  return done();
}

SharedClimb::Next SharedClimb::into_operator(const clang::CXXOperatorCallExpr* call) {
  if (context_.unit.declares(call->getDirectCallee())) return into_call(call);
  if (call->isAssignmentOp()) return into_assignment(call);
  const bool is_object = call->getArg(0) == at_;
  switch (call->getOperator()) {
    case clang::OO_Call:
      return is_object ? go_on(call) : into_call(call);
    case clang::OO_Arrow:
    case clang::OO_Star:
    case clang::OO_Subscript:
      return is_object ? go_on(call) : done();
    case clang::OO_PlusPlus:
    case clang::OO_MinusMinus:
      return leads_to_elements(at_->getType()) ? go_on(call) : write(at_);
    case clang::OO_Plus:
    case clang::OO_Minus:
      return leads_to_elements(call->getType()) ? call : done();
    default:
      return done();
  }
}

bool SharedClimb::hold_parameter(const clang::FunctionDecl* function, unsigned parameter) {
  const clang::FunctionDecl* definition = shown_body(function);
  const bool is_seen =
      definition && !definition->isDependentContext() && parameter < definition->getNumParams();
  if (is_seen) elements_.hold(definition->getParamDecl(parameter));
  return is_seen;
}

/// std::thread(function, image), std::bind(function, image)
bool SharedClimb::hold_bound(const clang::Expr* expr) {
  const std::optional<BoundCall> bound = bound_call(context_.unit, expr);
  if (!bound) return false;
  const unsigned argument = index_of(bound->arguments, at_);
  return argument >= bound->first && hold_parameter(bound->function, argument - bound->first);
}

/// a.swap(b), swap(a, b)
SharedClimb::Next SharedClimb::into_exchange(const clang::CallExpr* call) {
  if (!leads_to_elements(at_->getType())) return write(at_);
  for (const clang::Expr* argument : call->arguments()) elements_.hold_object(argument);
  if (const auto* method = llvm::dyn_cast<clang::CXXMemberCallExpr>(call))
    elements_.hold_object(method->getImplicitObjectArgument());
  return done();
}

SharedClimb::Next SharedClimb::into_call(const clang::CallExpr* call) {
  const clang::FunctionDecl* function = call->getDirectCallee();
  if (!function) return write(at_);
  if (passes_through(function) || hands_on(function) || makes_object(call)) return call;
  if (hold_bound(call)) return done();
  if (function->getNameAsString() == "swap") return into_exchange(call);
  const bool of_object =
      llvm::isa<clang::CXXOperatorCallExpr>(call) && llvm::isa<clang::CXXMethodDecl>(function);
  const unsigned argument = index_of({call->getArgs(), call->getNumArgs()}, at_);
  if (of_object && argument == 0) return done();
  const unsigned parameter = argument - (of_object ? 1 : 0);
  if (context_.unit.declares(function) && hold_parameter(function, parameter)) return done();
  return into_library(call, parameter);
}

/// What a container is given becomes part of it.
SharedClimb::Next SharedClimb::into_library(const clang::CallExpr* call, unsigned parameter) {
  const clang::FunctionDecl* function = call->getDirectCallee();
  const auto* method = llvm::dyn_cast<clang::CXXMemberCallExpr>(call);
  const clang::Expr* object = method ? method->getImplicitObjectArgument() : nullptr;
  const clang::CXXMethodDecl* called = method ? method->getMethodDecl() : nullptr;
  if (method && !called) return write(at_);  // through a pointer to member
  if (called && leads_to_elements(object->getType()) && !called->isConst()) {
    if (leads_to_elements(at_->getType())) elements_.hold_object(object);
    return done();
  }
  if (may_write_through(function, parameter)) return write(at_);
  const bool is_part = function->isInStdNamespace() && call->isPRValue() && call->getType()->isRecordType();
  return is_part && leads_to_elements(call->getType()) ? call : done();
}

SharedClimb::Next SharedClimb::into_construction(const clang::CXXConstructExpr* made) {
  const clang::CXXConstructorDecl* constructor = made->getConstructor();
  if (is_output(constructor->getParent())) return write(at_);
  if (hold_bound(made)) return done();
  if (context_.unit.declares(constructor) && !constructor->isImplicit()) {
    const unsigned parameter = index_of({made->getArgs(), made->getNumArgs()}, at_);
    const bool followed = hold_parameter(constructor, parameter);
    return followed || !may_write_through(constructor, parameter) ? done() : write(at_);
  }
  return leads_to_elements(made->getType()) ? made : done();
}

/// {image}: the first member of an aggregate of the package, or an element.
SharedClimb::Next SharedClimb::into_list(const clang::InitListExpr* list) {
  const clang::CXXRecordDecl* record = list->getType()->getAsCXXRecordDecl();
  if (!record || !context_.unit.source.in_package(record->getLocation())) return go_on(list);
  unsigned index = static_cast<unsigned>(std::distance(record->bases_begin(), record->bases_end()));
  for (const clang::FieldDecl* field : record->fields()) {
    if (index < list->getNumInits() && list->getInit(index) == at_) elements_.hold(field);
    ++index;
  }
  return done();
}

/// Of an object that leads to elements only the parts that do; of an element every part.
SharedClimb::Next SharedClimb::into_member(const clang::MemberExpr* member) {
  if (llvm::isa<clang::CXXMethodDecl>(member->getMemberDecl())) {
    const auto* call = llvm::dyn_cast_or_null<clang::CXXMemberCallExpr>(view_.parent(member));
    return call && call->getMethodDecl() ? into_method(call) : done();
  }
  const clang::QualType object = member->getBase()->getType();
  const bool is_handle = leads_to_elements(member->isArrow() ? object->getPointeeType() : object);
  return !is_handle || leads_to_elements(member->getType()) ? member : done();
}

/// A member function of the image, of a pointer to it, of an iterator or of a container.
SharedClimb::Next SharedClimb::into_method(const clang::CXXMemberCallExpr* call) {
  const std::string name = call->getMethodDecl()->getNameAsString();
  if (context_.unit.declares(call->getMethodDecl())) return done();
  if (name == "swap") return into_exchange(call);
  if (name == "setTo") return write(call);
  if (name == "forEach") return takes_const_elements(call) ? done() : write(call);
  const bool of_image = qualified_name_of(call->getMethodDecl()->getParent()) == "cv_bridge::CvImage";
  return name == "clone" || of_image ? done() : go_on(call);
}

SharedClimb::Next SharedClimb::into_expression(const clang::Expr* parent) {
  if (const auto* op = llvm::dyn_cast<clang::BinaryOperator>(parent)) return into_binary(op);
  if (const auto* op = llvm::dyn_cast<clang::UnaryOperator>(parent)) {
    const bool writes = op->isIncrementDecrementOp() && !at_->getType()->isAnyPointerType();
    return writes ? write(at_) : go_on(op);
  }
  if (const auto* call = llvm::dyn_cast<clang::CXXOperatorCallExpr>(parent)) return into_operator(call);
  if (const auto* call = llvm::dyn_cast<clang::CallExpr>(parent)) return into_call(call);
  if (const auto* made = llvm::dyn_cast<clang::CXXConstructExpr>(parent)) return into_construction(made);
  if (const auto* member = llvm::dyn_cast<clang::MemberExpr>(parent)) return into_member(member);
  if (const auto* list = llvm::dyn_cast<clang::InitListExpr>(parent)) return into_list(list);
  if (const auto* lambda = llvm::dyn_cast<clang::LambdaExpr>(parent)) return into_capture(lambda);
  if (const auto* choice = llvm::dyn_cast<clang::AbstractConditionalOperator>(parent))
    return choice->getCond() == at_ ? done() : go_on(choice);
  const auto* cast = llvm::dyn_cast<clang::CastExpr>(parent);
  if (cast && cast->getCastKind() == clang::CK_PointerToIntegral)
    return write(at_);  // numbers are not followed
  const bool wraps =
      llvm::isa<clang::CastExpr, clang::ParenExpr, clang::FullExpr, clang::MaterializeTemporaryExpr,
                clang::CXXBindTemporaryExpr, clang::ArraySubscriptExpr, clang::CXXNewExpr,
                clang::CXXStdInitializerListExpr>(parent);
  return wraps ? go_on(parent) : done();
}

}  // namespace tzc::rewriter
