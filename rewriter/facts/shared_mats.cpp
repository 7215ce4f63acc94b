// SPDX-License-Identifier: BSD-3-Clause
#include "facts/shared_mats.h"

#include <clang/AST/StmtCXX.h>

#include "facts/calls.h"
#include "model/codes.h"

namespace tzc::rewriter {
namespace {

std::string class_of(clang::QualType type) {
  const clang::CXXRecordDecl* record = type.getNonReferenceType().getCanonicalType()->getAsCXXRecordDecl();
  return record ? qualified_name_of(record) : "";
}

bool is_mat(clang::QualType type) {
  const std::string name = class_of(type);
  return name == "cv::Mat" || name == "cv::Mat_";
}

bool is_smart_pointer(clang::QualType type) {
  const std::string name = class_of(type);
  return name == "boost::shared_ptr" || name == "std::shared_ptr";
}

/// Whether something of this type still leads to the elements.
bool leads_on(clang::QualType type) {
  return is_mat(type) || is_smart_pointer(type) || type->isAnyPointerType() ||
         llvm::StringRef(class_of(type)).contains("Iterator");
}

bool is_share(const clang::Stmt* stmt) {
  const auto* call = llvm::dyn_cast<clang::CallExpr>(stmt);
  const clang::FunctionDecl* function = call ? call->getDirectCallee() : nullptr;
  return function && qualified_name_of(function) == "cv_bridge::toCvShare" && call->getNumArgs() > 0;
}

unsigned index_of(llvm::ArrayRef<const clang::Expr*> arguments, const clang::Expr* argument) {
  return static_cast<unsigned>(llvm::find(arguments, argument) - arguments.begin());
}

}  // namespace

const FunctionView& SharedMats::view_of(const clang::FunctionDecl* definition) {
  std::unique_ptr<FunctionView>& view = views_[definition];
  if (!view) view = std::make_unique<FunctionView>(definition);
  return *view;
}

void SharedMats::note(const clang::Expr* write, const Messages& messages) {
  if (!write) return;
  const Obstacle why{codes::TZC2001, "the cv::Mat that shares its data may be written to",
                     location_of(context_.unit.source.where(write->getBeginLoc()))};
  for (const EntityId& key : messages) context_.found.data_writes.push_back({key, why, false});
}

void SharedMats::analyse(const clang::FunctionDecl* definition) {
  functions_.push_back(definition);
  const FunctionView& view = view_of(definition);
  for (const clang::Stmt* stmt : view.statements()) {
    if (!is_share(stmt)) continue;
    const auto* call = llvm::cast<clang::CallExpr>(stmt);
    current_ = context_.sources_of(call->getArg(0));
    seen_.clear();
    if (!current_.empty()) note(write_through(view, call), current_);
  }
}

void SharedMats::finish() {
  const auto kept = std::move(kept_);
  for (const auto& [field, messages] : kept)
    for (const clang::FunctionDecl* function : functions_) {
      const FunctionView& view = view_of(function);
      for (const clang::Stmt* stmt : view.statements()) {
        const auto* member = llvm::dyn_cast<clang::MemberExpr>(stmt);
        seen_.clear();
        if (member && member->getMemberDecl() == field) note(write_through(view, member), messages);
      }
    }
}

const clang::Expr* SharedMats::write_in_uses(const FunctionView& view, const clang::ValueDecl* variable) {
  if (!seen_.insert(variable).second) return nullptr;
  for (const clang::DeclRefExpr* use : view.uses(variable))
    if (const clang::Expr* write = write_through(view, use)) return write;
  return nullptr;
}

/// A function of the package is followed; another one writes to what it takes by non-const reference or pointer.
const clang::Expr* SharedMats::write_in(const clang::FunctionDecl* function, unsigned parameter,
                                        const clang::Expr* at) {
  if (parameter >= function->getNumParams()) return nullptr;
  const clang::FunctionDecl* definition = nullptr;
  if (context_.unit.declares(function) && function->isDefined(definition) && definition->getBody() &&
      !definition->isDependentContext())
    return write_in_uses(view_of(definition), definition->getParamDecl(parameter));
  const clang::QualType type = function->getParamDecl(parameter)->getType();
  const clang::QualType target = type->getPointeeType();
  return !target.isNull() && !target.isConstQualified() && !is_smart_pointer(target) ? at : nullptr;
}

const clang::Expr* SharedMats::write_in_target(const FunctionView& view, const clang::Expr* target) {
  target = target->IgnoreParenImpCasts();
  if (const auto* name = llvm::dyn_cast<clang::DeclRefExpr>(target))
    return write_in_uses(view, name->getDecl());
  if (const auto* member = llvm::dyn_cast<clang::MemberExpr>(target)) {
    Messages& messages = kept_[member->getMemberDecl()];
    messages.insert(messages.end(), current_.begin(), current_.end());
  }
  return nullptr;
}

const clang::Expr* SharedMats::write_in_construction(const clang::CXXConstructExpr* made,
                                                     const clang::Expr* at) {
  const std::string name = qualified_name_of(made->getConstructor()->getParent());
  if (name == "cv::_OutputArray" || name == "cv::_InputOutputArray") return at;
  if (!context_.unit.declares(made->getConstructor())) return nullptr;
  return write_in(made->getConstructor(), index_of({made->getArgs(), made->getNumArgs()}, at), at);
}

SharedMats::Step SharedMats::into_binary(const FunctionView& view, const clang::Expr* at,
                                         const clang::BinaryOperator* op) {
  if (op->isAssignmentOp() && op->getLHS() == at)
    return at->getType()->isAnyPointerType() ? Step{} : Step{at, nullptr};
  if (op->isAssignmentOp()) return {write_in_target(view, op->getLHS()), nullptr};
  const bool goes_on = op->isAdditiveOp() || (op->getOpcode() == clang::BO_Comma && op->getRHS() == at);
  return {nullptr, goes_on ? op : nullptr};
}

SharedMats::Step SharedMats::into_operator(const FunctionView& view, const clang::Expr* at,
                                           const clang::CXXOperatorCallExpr* call) {
  const bool is_target = call->getArg(0) == at;
  if (call->isAssignmentOp()) {
    const bool rebinds =
        call->getOperator() == clang::OO_Equal &&
        (is_smart_pointer(at->getType()) || (is_mat(at->getType()) && is_mat(call->getArg(1)->getType())));
    if (is_target) return {rebinds ? nullptr : at, nullptr};
    return {call->getOperator() == clang::OO_Equal ? write_in_target(view, call->getArg(0)) : nullptr,
            nullptr};
  }
  switch (call->getOperator()) {
    case clang::OO_Arrow:
    case clang::OO_Star:
    case clang::OO_Subscript:
    case clang::OO_Call:
      return {nullptr, is_target ? call : nullptr};
    case clang::OO_PlusPlus:
    case clang::OO_MinusMinus:
      return {leads_on(at->getType()) ? nullptr : at, nullptr};
    default:
      return {};
  }
}

SharedMats::Step SharedMats::into_call(const clang::Expr* at, const clang::CallExpr* call) {
  const clang::FunctionDecl* function = call->getDirectCallee();
  if (!function) return {at, nullptr};
  if (passes_through(function)) return {nullptr, call};
  const llvm::StringRef name = function->getIdentifier() ? function->getName() : "";
  if (name == "const_pointer_cast" || name == "static_pointer_cast") return {nullptr, call};
  return {write_in(function, index_of({call->getArgs(), call->getNumArgs()}, at), at), nullptr};
}

/// A function of the image, of a pointer to it or of an iterator.
SharedMats::Step SharedMats::into_method(const FunctionView& view, const clang::MemberExpr* member) {
  const auto* call = llvm::dyn_cast_or_null<clang::CXXMemberCallExpr>(view.parent(member));
  if (!call || !call->getMethodDecl()) return {};
  const std::string name = call->getMethodDecl()->getNameAsString();
  if (name == "setTo") return {call, nullptr};
  if (name == "clone" || class_of(member->getBase()->getType()) == "cv_bridge::CvImage") return {};
  return {nullptr, call->isGLValue() || leads_on(call->getType()) ? call : nullptr};
}

SharedMats::Step SharedMats::into(const FunctionView& view, const clang::Expr* at,
                                  const clang::Expr* parent) {
  if (const auto* cast = llvm::dyn_cast<clang::ImplicitCastExpr>(parent))
    return {nullptr, cast->isGLValue() || leads_on(cast->getType()) ? cast : nullptr};
  if (const auto* op = llvm::dyn_cast<clang::BinaryOperator>(parent)) return into_binary(view, at, op);
  if (const auto* op = llvm::dyn_cast<clang::UnaryOperator>(parent)) {
    const bool writes = op->isIncrementDecrementOp() && !at->getType()->isAnyPointerType();
    return writes ? Step{at, nullptr} : Step{nullptr, op};
  }
  if (const auto* call = llvm::dyn_cast<clang::CXXOperatorCallExpr>(parent))
    return context_.unit.declares(call->getDirectCallee()) ? into_call(at, call)
                                                           : into_operator(view, at, call);
  if (const auto* call = llvm::dyn_cast<clang::CallExpr>(parent)) return into_call(at, call);
  if (const auto* made = llvm::dyn_cast<clang::CXXConstructExpr>(parent)) {
    if (leads_on(made->getType())) return {nullptr, made};
    return {write_in_construction(made, at), nullptr};
  }
  if (const auto* member = llvm::dyn_cast<clang::MemberExpr>(parent)) {
    if (llvm::isa<clang::CXXMethodDecl>(member->getMemberDecl())) return into_method(view, member);
    const bool in_header = is_mat(at->getType()) && member->getType()->isArithmeticType();
    return {nullptr, in_header ? nullptr : member};
  }
  const bool wraps =
      llvm::isa<clang::ExplicitCastExpr, clang::ParenExpr, clang::FullExpr, clang::MaterializeTemporaryExpr,
                clang::CXXBindTemporaryExpr, clang::ArraySubscriptExpr, clang::ConditionalOperator>(parent);
  return {nullptr, wraps ? parent : nullptr};
}

const clang::Expr* SharedMats::write_through(const FunctionView& view, const clang::Expr* at) {
  while (at) {
    const clang::Stmt* parent = view.parent(at);
    if (const auto* declaration = llvm::dyn_cast_or_null<clang::DeclStmt>(parent)) {
      for (const clang::Decl* decl : declaration->decls())
        if (const auto* variable = llvm::dyn_cast<clang::VarDecl>(decl);
            variable && variable->getInit() == at)
          return write_in_uses(view, variable);
      return nullptr;
    }
    const auto* expr = llvm::dyn_cast_or_null<clang::Expr>(parent);
    if (!expr) return nullptr;
    const Step step = into(view, at, expr);
    if (step.write) return step.write;
    at = step.next;
  }
  return nullptr;
}

}  // namespace tzc::rewriter
