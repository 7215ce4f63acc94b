// SPDX-License-Identifier: BSD-3-Clause
#include "facts/flow/message_copies.h"

#include <clang/AST/DeclTemplate.h>
#include <clang/AST/ExprCXX.h>
#include <clang/AST/Stmt.h>

#include <iterator>

#include "facts/syntax/ast_walk.h"
#include "facts/syntax/calls.h"
#include "facts/syntax/library_calls.h"
#include "facts/syntax/message_parts.h"
#include "facts/syntax/message_type.h"
#include "parse/ast_visitor.h"

namespace tzc::rewriter {
namespace {

/// As it is written: what is converted (std::cref, a derived class) converts to a stock message alone.
bool is_message_object(const clang::Expr* expr) {
  const clang::Expr* written = expr->IgnoreParenImpCasts();
  const auto* call = llvm::dyn_cast<clang::CXXMemberCallExpr>(written);
  const bool converts = call && llvm::isa_and_nonnull<clang::CXXConversionDecl>(call->getMethodDecl());
  return expr->isLValue() && written->isLValue() && !converts && message_of(written->getType());
}

/// Nothing but an initializer: a comment, an attribute or another configuration's code would be lost with it, and a pack (`args...`) is
/// one expression in this instance of a template only.
bool is_code_alone(const std::string& text) {
  static const char* const others[] = {"//", "/*", "[[", "#", "\\\n", "..."};
  return llvm::none_of(others, [&](const char* other) { return text.find(other) != std::string::npos; });
}

class CallFinder : public AstVisitor {
 public:
  explicit CallFinder(const Unit& unit) : unit_(unit) {}
  bool VisitCallExpr(clang::CallExpr* call) override {
    const clang::FunctionDecl* callee = call->getDirectCallee();
    found = found || !callee || !calls_no_package_code(unit_, callee, {call->getArgs(), call->getNumArgs()});
    return !found;
  }
  bool found = false;

 private:
  const Unit& unit_;
};

bool may_run_package_code(const Unit& unit, const clang::Expr* source) {
  CallFinder finder(unit);
  finder.TraverseStmt(const_cast<clang::Expr*>(source));
  return finder.found;
}

/// What is assigned is written as the initializer was, so no type may be named there that a port changes: in casts of messages, or in what
/// a closure does.
class TypeNameFinder : public AstVisitor {
 public:
  explicit TypeNameFinder(const Unit& unit) : unit_(unit) {}
  bool VisitLambdaExpr(clang::LambdaExpr*) override {
    found = true;
    return false;
  }
  bool VisitExplicitCastExpr(clang::ExplicitCastExpr* cast) override {
    found = found || carried_by(cast->getType(), unit_.rules).has_value();
    return !found;
  }
  bool VisitCallExpr(clang::CallExpr* call) override {
    found = found || recasts_pointer(unit_, call);
    return !found;
  }
  bool found = false;

 private:
  const Unit& unit_;
};

bool names_message_type(const Unit& unit, const clang::Expr* source) {
  TypeNameFinder finder(unit);
  finder.TraverseStmt(const_cast<clang::Expr*>(source));
  return finder.found;
}

/// What the variable alone is made with, if the condition holds for it: `make_shared<M>(*in)` in auto p = make_shared<M>(*in),
/// `new M(*in)` in MPtr p(new M(*in)). Null: there is none.
const clang::Expr* whole_initializer(const clang::VarDecl* variable,
                                     llvm::function_ref<bool(const clang::Expr*)> is_meant) {
  const clang::Expr* value = variable->getInit();
  while (value && !is_meant(value)) {
    const clang::Expr* inner = value->IgnoreImplicit();
    const auto* construct = llvm::dyn_cast<clang::CXXConstructExpr>(inner);
    const auto* parens = llvm::dyn_cast<clang::ParenExpr>(inner);
    if (inner == value) inner = parens ? parens->getSubExpr() : nullptr;
    if (construct && construct == value)
      inner = construct->getNumArgs() == 1 ? construct->getArg(0) : nullptr;
    value = inner;
  }
  return value;
}

/// if (Image last = image; ...): no statement can stand behind it.
bool stands_in_head(const Unit& unit, const clang::DeclStmt* declaration) {
  const auto* around = parent_as<clang::Stmt>(unit.ast(), *declaration);
  return !llvm::isa_and_nonnull<clang::CompoundStmt, clang::SwitchCase, clang::LabelStmt>(around);
}

/// From behind a variable's name to its semicolon: ` = *in`, `(*in)`.
std::optional<Place> initializer_of(const Unit& unit, const clang::VarDecl* variable,
                                    const clang::DeclStmt* statement) {
  const std::optional<Place> name = unit.source.place(variable->getLocation());
  const std::optional<Place> end = unit.source.behind(statement->getSourceRange());
  if (!name || !end || name->file != end->file) return {};
  Place place = *name;
  place.begin = name->end;
  place.end = end->end;
  const std::string text = unit.source.text(place);
  if (text.empty() || text.back() != ';' || !is_code_alone(text)) return {};
  --place.end;
  return place;
}

/// The variable that a template has where its instances have theirs.
class VariableAt : public AstVisitor {
 public:
  explicit VariableAt(clang::SourceLocation where) : where_(where) {}
  bool VisitVarDecl(clang::VarDecl* variable) override {
    if (variable->getLocation() == where_) found = variable;
    return !found;
  }
  const clang::VarDecl* found = nullptr;

 private:
  const clang::SourceLocation where_;
};

/// A generic lambda that all its calls give the same types. They are where it is, so nobody else can give it others.
bool has_one_instance(const clang::FunctionDecl* function) {
  const clang::FunctionTemplateDecl* pattern = function->getPrimaryTemplate();
  if (!pattern || !is_lambda(function)) return false;
  const auto instances = pattern->specializations();
  return std::distance(instances.begin(), instances.end()) == 1;
}

/// Whether the variable's type is another one in each instance of a template. A type that is named there would be that of this instance alone,
/// and the template could not be given anything else any more. What does not depend on the template's parameters has one type.
bool varies_by_instance(const clang::VarDecl* variable) {
  const clang::FunctionDecl* instance = nullptr;  // the outermost
  for (const clang::DeclContext* at = variable->getDeclContext(); at; at = at->getParent()) {
    const auto* function = llvm::dyn_cast<clang::FunctionDecl>(at);
    if (function && function->isTemplateInstantiation() && !has_one_instance(function)) instance = function;
  }
  if (!instance) return false;
  VariableAt pattern(variable->getLocation());
  pattern.TraverseStmt(pattern_of(instance)->getBody());
  return !pattern.found || pattern.found->getType()->isDependentType();
}

/// `auto out = *in;` has to name the type when nothing is left that tells it.
std::optional<Change> named_type(const Unit& unit, const clang::VarDecl* variable) {
  const auto deduced = variable->getTypeSourceInfo()->getTypeLoc().getAs<clang::AutoTypeLoc>();
  const std::optional<Place> place =
      deduced.isNull() ? std::nullopt : unit.source.place(deduced.getNameLoc());
  const std::string message = message_of(variable->getType())->name;
  return place ? std::optional(Change{*place, twin_name(message), "message-type", {twin_header(message)}})
               : std::nullopt;
}

}  // namespace

const clang::Expr* copied_by(const clang::Expr* initializer) {
  const clang::Expr* made = initializer->IgnoreImplicit();
  while (const auto* named = llvm::dyn_cast<clang::CXXFunctionalCastExpr>(made))
    made = named->getSubExpr()->IgnoreImplicit();
  const auto* construct = llvm::dyn_cast<clang::CXXConstructExpr>(made);
  if (!construct || construct->getNumArgs() == 0) return nullptr;
  const clang::Expr* source = construct->getArg(0);
  if (construct->getConstructor()->isCopyConstructor() && source->isLValue()) return source;
  // Before C++17 the temporary is moved, as the program may leave out.
  const bool moves = construct->getConstructor()->isCopyOrMoveConstructor() && source->isPRValue();
  return moves || construct->isElidable() ? copied_by(source) : nullptr;
}

std::vector<Change> move_out_of_result(const Unit& unit, const clang::Expr* initializer) {
  const clang::Expr* message = copied_by(initializer);
  if (!message) return {};
  message = message->IgnoreImpCasts();
  const clang::Expr* pointer = pointer_followed(message->IgnoreParens());
  const auto* call =
      pointer ? llvm::dyn_cast<clang::CallExpr>(pointer->IgnoreParens()->IgnoreImplicit()) : nullptr;
  const auto where =
      call && builds_message(unit, call) ? unit.source.place(message->getSourceRange()) : std::nullopt;
  if (!where) return {};
  const Place begin{where->file, where->begin, where->begin, where->line, where->column};
  const Place end{where->file, where->end, where->end, where->line, where->column};
  return {{begin, "std::move(", "message-type", {}}, {end, ")", "message-type", {}}};
}

std::optional<LaterCopy> later_copy(const Unit& unit, const clang::VarDecl* variable) {
  if (!variable->hasLocalStorage() || llvm::isa<clang::ParmVarDecl>(variable) || !variable->getInit() ||
      variable->getType().isConstQualified() || variable->getType()->isReferenceType() ||
      !message_of(variable->getType()))
    return {};
  const auto* statement = parent_as<clang::DeclStmt>(unit.ast(), *variable);
  const clang::Expr* source = copied_by(variable->getInit());
  if (!source || !is_message_object(source) || !statement || !statement->isSingleDecl() ||
      stands_in_head(unit, statement) || !unit.source.place(source->getSourceRange()) ||
      names_message_type(unit, source) || !move_out_of_result(unit, variable->getInit()).empty())
    return {};
  const std::optional<Place> initializer = initializer_of(unit, variable, statement);
  if (!initializer) return {};
  LaterCopy copy{
      {{*initializer, "", "later-copy", {}}}, unit.text(source), may_run_package_code(unit, source)};
  if (!variable->getTypeSourceInfo()->getTypeLoc().getContainedAutoTypeLoc()) return copy;
  const std::optional<Change> type = varies_by_instance(variable) ? std::nullopt : named_type(unit, variable);
  if (!type) return {};
  copy.without.push_back(*type);
  return copy;
}

const clang::Expr* made_from(const clang::Expr* expr) {
  const auto* call = llvm::dyn_cast<clang::CallExpr>(expr);
  const auto* made = llvm::dyn_cast<clang::CXXNewExpr>(expr);
  const clang::Expr* value = made ? made->getInitializer() : nullptr;
  if (const auto* construct = llvm::dyn_cast_or_null<clang::CXXConstructExpr>(value))
    value = construct->getNumArgs() == 1 ? construct->getArg(0) : nullptr;
  if (call && call->getNumArgs() == 1) value = call->getArg(0);
  return value && message_of(value->getType().getNonReferenceType()) ? value : nullptr;
}

bool copies_message(const clang::Expr* made) {
  const clang::Expr* source = made_from(made);
  return source && is_message_object(source);
}

std::optional<LaterCopy> later_copy(const Unit& unit, const clang::VarDecl* variable,
                                    const clang::Expr* made) {
  const clang::QualType pointee = pointee_of(variable->getType());
  const auto* statement = parent_as<clang::DeclStmt>(unit.ast(), *variable);
  if (!copies_message(made) || !variable->hasLocalStorage() || pointee.isNull() ||
      pointee.isConstQualified() || !statement || !statement->isSingleDecl() ||
      stands_in_head(unit, statement) ||
      !whole_initializer(variable, [&](const clang::Expr* part) { return part == made; }))
    return {};
  const clang::Expr* source = made_from(made);
  const std::optional<Place> place = unit.source.place(source->getSourceRange());
  const std::optional<Place> call = unit.source.place({source->getBeginLoc(), made->getEndLoc()});
  if (!place || !call || !is_code_alone(unit.source.text(*call)) || names_message_type(unit, source))
    return {};
  return LaterCopy{{{*place, "", "later-copy", {}}}, unit.text(source), may_run_package_code(unit, source)};
}

bool has_memory_for_copy(const Unit& unit, const clang::VarDecl* variable) {
  if (!variable->getInit()) return false;
  if (later_copy(unit, variable) || !move_out_of_result(unit, variable->getInit()).empty()) return true;
  const clang::Expr* const made = whole_initializer(variable, copies_message);
  return made && later_copy(unit, variable, made);
}

bool is_copied_by_assignment(const clang::Expr* target, const clang::Expr* value) {
  return is_message_object(value) && message_of(target->getType());
}

namespace {

/// A choice (`a ? b : c`) is one expression of two messages, each of which may or may not be ported.
bool is_one_message(const clang::Expr* value) {
  const auto* unary = llvm::dyn_cast<clang::UnaryOperator>(value);
  const auto* call = llvm::dyn_cast<clang::CXXOperatorCallExpr>(value);
  return llvm::isa<clang::DeclRefExpr, clang::MemberExpr, clang::ArraySubscriptExpr>(value) ||
         (unary && unary->getOpcode() == clang::UO_Deref) ||
         (call && (call->getOperator() == clang::OO_Star || call->getOperator() == clang::OO_Subscript));
}

}  // namespace

std::vector<Change> copied_as_stock(const Unit& unit, const clang::Expr* value) {
  const auto message = message_of(value->getType());
  std::optional<Place> place = unit.source.place(value->getSourceRange());
  if (!message || !place || value->isTypeDependent() || !is_one_message(value->IgnoreParenImpCasts()))
    return {};
  std::string type = message->name;
  type.replace(type.find('/'), 1, "::");
  Place open = *place, close = *place;
  open.end = open.begin;
  close.begin = close.end;
  return {{open, type + "(", "as-stock", {}}, {close, ")", "as-stock", {}}};
}

}  // namespace tzc::rewriter
