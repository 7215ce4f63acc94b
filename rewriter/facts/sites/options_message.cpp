// SPDX-License-Identifier: BSD-3-Clause
// nh.advertise(options) and nh.subscribe(options): the type is named where the options were made.

#include "facts/syntax/ast_walk.h"
#include "facts/syntax/calls.h"
#include "facts/syntax/library_advertise.h"
#include "facts/syntax/message_type.h"
#include "parse/ast_visitor.h"

namespace tzc::rewriter {
namespace {

const clang::VarDecl* variable_of(const clang::Expr* expr) {
  const auto* reference = llvm::dyn_cast<clang::DeclRefExpr>(expr->IgnoreParenImpCasts());
  return reference ? llvm::dyn_cast<clang::VarDecl>(reference->getDecl()) : nullptr;
}

/// The message among the template arguments of create<M>, init<M>, initByFullCallbackType<const MConstPtr&>.
std::optional<clang::QualType> message_among(const clang::FunctionDecl* function) {
  const clang::TemplateArgumentList* arguments = function->getTemplateSpecializationArgs();
  if (!arguments) return {};
  for (const clang::TemplateArgument& argument : arguments->asArray()) {
    if (argument.getKind() != clang::TemplateArgument::Type) continue;
    const clang::QualType pointee = pointee_of(argument.getAsType());
    const clang::QualType type = pointee.isNull() ? argument.getAsType() : pointee;
    if (message_of(type)) return type.getNonReferenceType().getUnqualifiedType();
  }
  return {};
}

bool creates_options(const clang::CallExpr* call) {
  const clang::FunctionDecl* function = call->getDirectCallee();
  const std::string name = function ? qualified_name_of(function) : "";
  return name == "ros::SubscribeOptions::create" || name == "ros::AdvertiseOptions::create";
}

/// The calls that fill the options: o.init<M>(...), o = SubscribeOptions::create<M>(...).
class OptionsVisitor : public AstVisitor {
 public:
  explicit OptionsVisitor(const clang::VarDecl* variable) : variable_(variable) {}
  std::vector<const clang::CallExpr*> found;

  bool VisitCXXMemberCallExpr(clang::CXXMemberCallExpr* call) override {
    if (call->getMethodDecl() && variable_of(call->getImplicitObjectArgument()) == variable_)
      found.push_back(call);
    return true;
  }
  bool VisitVarDecl(clang::VarDecl* variable) override {
    if (variable == variable_) note_created(variable->getInit());
    return true;
  }
  bool VisitCallExpr(clang::CallExpr* call) override {
    const auto* op = llvm::dyn_cast<clang::CXXOperatorCallExpr>(call);
    if (op && op->getOperator() == clang::OO_Equal && variable_of(op->getArg(0)) == variable_)
      note_created(op->getArg(1));
    return true;
  }

 private:
  void note_created(const clang::Stmt* value) {
    if (!value) return;
    if (const auto* call = llvm::dyn_cast<clang::CallExpr>(value); call && creates_options(call))
      found.push_back(call);
    for (const clang::Stmt* child : value->children()) note_created(child);
  }
  const clang::VarDecl* variable_;
};

}  // namespace

std::vector<const clang::CallExpr*> options_calls(const Unit& unit, const clang::Expr* options) {
  const clang::VarDecl* variable = variable_of(options);
  const clang::FunctionDecl* function = variable ? enclosing_function(unit.ast(), *options) : nullptr;
  if (!function || !function->getBody()) return {};
  OptionsVisitor visitor(variable);
  visitor.TraverseStmt(function->getBody());
  return visitor.found;
}

std::optional<clang::QualType> options_message(const Unit& unit, const clang::Expr* options) {
  std::optional<clang::QualType> found;
  for (const clang::CallExpr* call : options_calls(unit, options)) {
    const auto type = call->getDirectCallee() ? message_among(call->getDirectCallee()) : std::nullopt;
    if (type && found && found->getCanonicalType() != type->getCanonicalType()) return {};
    if (type) found = type;
  }
  return found;
}

std::string written_options_message(const Unit& unit, const clang::Expr* options) {
  for (const clang::CallExpr* call : options_calls(unit, options))
    for (const clang::TemplateArgumentLoc& argument : written_arguments_of(call)) {
      if (argument.getArgument().getKind() != clang::TemplateArgument::Type) continue;
      const clang::QualType type = argument.getArgument().getAsType();
      if (message_of(type) && !type->isReferenceType() && !type.isConstQualified())
        return unit.source.text(argument.getSourceRange());
    }
  return "";
}

bool are_of_pattern(const clang::Expr* options) {
  options = options->IgnoreParenImpCasts();
  const auto* name = llvm::dyn_cast<clang::DeclRefExpr>(options);
  const auto* member = llvm::dyn_cast<clang::MemberExpr>(options);
  const clang::ValueDecl* decl = name ? name->getDecl() : member ? member->getMemberDecl() : nullptr;
  return decl && decl->getDeclContext()->isDependentContext();
}

}  // namespace tzc::rewriter
