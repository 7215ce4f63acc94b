// SPDX-License-Identifier: BSD-3-Clause
#include "facts/collect.h"

#include <vector>

#include "facts/collectors.h"
#include "facts/escape/thread_starts.h"
#include "facts/flow/array_casts.h"
#include "facts/flow/callbacks.h"
#include "facts/flow/size_questions.h"
#include "facts/syntax/ast_walk.h"
#include "facts/syntax/message_type.h"
#include "parse/ast_visitor.h"

namespace tzc::rewriter {
namespace {

/// Takes what asks for the size or the name of a type.
class Questions : public AstVisitor {
 public:
  explicit Questions(const Unit& unit) : unit_(unit), to_(unit) {}

  bool VisitUnaryExprOrTypeTraitExpr(clang::UnaryExprOrTypeTraitExpr* question) override {
    note_size_question(unit_, to_.entities(), question->getTypeOfArgument(), question->getBeginLoc());
    return true;
  }
  bool VisitOffsetOfExpr(clang::OffsetOfExpr* question) override {
    note_size_question(unit_, to_.entities(), question->getTypeSourceInfo()->getType(),
                       question->getBeginLoc());
    return true;
  }
  bool VisitPredefinedExpr(clang::PredefinedExpr* name) override {
    note_signature_question(unit_, to_.entities(), name);
    return true;
  }

 protected:
  const Unit& unit_;
  Collectors to_;
};

/// The dispatch table: passes each kind of node to its collector.
class Dispatcher : public Questions {
 public:
  explicit Dispatcher(const Unit& unit)
      : Questions(unit),
        callbacks_(unit, to_.entities()),
        threads_(unit),
        arrays_cast_(unit, to_.entities()) {}
  bool shouldVisitTemplateInstantiations() const override { return true; }

  bool VisitVarDecl(clang::VarDecl* variable) override {
    to_.declaration(variable);
    return true;
  }
  /// Something of the package may be called tzc, other than the namespace that TZC has.
  bool VisitNamedDecl(clang::NamedDecl* decl) override {
    const bool is_own = !llvm::isa<clang::NamespaceDecl>(decl) ||
                        !decl->getDeclContext()->getRedeclContext()->isTranslationUnit();
    shadows_tzc_ |= is_own && decl->getIdentifier() && decl->getName() == "tzc";
    return true;
  }
  bool VisitFieldDecl(clang::FieldDecl* field) override {
    to_.entities().declare(field);
    if (field->hasInClassInitializer()) to_.early_calls(field->getInClassInitializer());
    return true;
  }
  bool VisitFunctionDecl(clang::FunctionDecl* function) override {
    to_.function(function);
    const bool own = !is_lambda(function) || function->getTemplateInstantiationPattern();
    if (function->isThisDeclarationADefinition() && !function->hasDefiningAttr() &&
        !function->isDependentContext() && own)
      functions_.push_back(function);
    return true;
  }
  bool VisitCXXRecordDecl(clang::CXXRecordDecl* record) override {
    if (record->isThisDeclarationADefinition()) to_.bases(record);
    return true;
  }
  bool VisitCXXForRangeStmt(clang::CXXForRangeStmt* loop) override {
    to_.flow().loop_over(loop);
    return true;
  }
  bool VisitDeclRefExpr(clang::DeclRefExpr* reference) override {
    if (const auto* function = llvm::dyn_cast<clang::FunctionDecl>(reference->getDecl()))
      note_function(function, reference);
    else
      to_.name(reference, reference->getDecl());
    return true;
  }
  bool VisitMemberExpr(clang::MemberExpr* member) override {
    if (is_data_array(member->getType()) && !member->isTypeDependent()) arrays_.push_back(member);
    to_.flow().check_union(member);
    arrays_cast_.member(member);
    if (llvm::isa<clang::FieldDecl, clang::VarDecl>(member->getMemberDecl()))
      to_.name(member, member->getMemberDecl());
    return true;
  }
  bool VisitCXXNewExpr(clang::CXXNewExpr* expr) override {
    to_.object(expr, expr->getAllocatedTypeSourceInfo());
    return true;
  }
  bool VisitCXXTemporaryObjectExpr(clang::CXXTemporaryObjectExpr* expr) override {
    to_.object(expr, expr->getTypeSourceInfo());
    return true;
  }
  bool VisitExplicitCastExpr(clang::ExplicitCastExpr* cast) override {
    to_.flow().check_const_cast(cast);
    arrays_cast_.cast(cast);
    to_.object(cast, cast->getTypeInfoAsWritten());
    return true;
  }
  bool VisitImplicitCastExpr(clang::ImplicitCastExpr* cast) override {
    arrays_cast_.cast(cast);
    return true;
  }
  bool VisitCXXConstructExpr(clang::CXXConstructExpr* construct) override {
    to_.flow().check_construction(construct);
    to_.construction(construct);
    return true;
  }
  bool VisitVAArgExpr(clang::VAArgExpr* argument) override {
    to_.flow().check_variable_argument(argument);
    arrays_cast_.variable_argument(argument);
    return true;
  }
  bool VisitCallExpr(clang::CallExpr* call) override {
    to_.flow().check_call(call);
    arrays_cast_.call(call);
    to_.call(call);
    return true;
  }
  bool VisitLambdaExpr(clang::LambdaExpr* lambda) override {
    callbacks_.check_lambda(lambda);
    if (unit_.source.in_package(lambda->getBeginLoc())) threads_.note(lambda);
    return true;
  }

  Facts finish() {
    to_.escapes(functions_, arrays_);
    Facts facts = to_.finish();
    facts.merge(threads_.take());
    static_cast<ArrayCastFacts&>(facts) = arrays_cast_.found();
    facts.shadows_tzc = shadows_tzc_;
    return facts;
  }

 private:
  void note_function(const clang::FunctionDecl* function, const clang::DeclRefExpr* reference) {
    if (callbacks_.check_address_taken(function, reference)) threads_.note(function, reference);
  }

  CallbackPins callbacks_;
  ThreadStarts threads_;
  ArrayCastCollector arrays_cast_;
  std::vector<const clang::FunctionDecl*> functions_;
  std::vector<const clang::MemberExpr*> arrays_;
  bool shadows_tzc_ = false;
};

}  // namespace

Facts collect(const Unit& unit) {
  Dispatcher dispatcher(unit);
  dispatcher.TraverseAST(unit.ast());
  return dispatcher.finish();
}

}  // namespace tzc::rewriter
