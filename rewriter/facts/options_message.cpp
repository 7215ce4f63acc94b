// SPDX-License-Identifier: BSD-3-Clause
// nh.advertise(options) and nh.subscribe(options): the type is named where the options were made.

#include "facts/ast_walk.h"
#include "facts/calls.h"
#include "facts/message_type.h"
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

class OptionsVisitor : public AstVisitor {
 public:
  explicit OptionsVisitor(const clang::VarDecl* variable) : variable_(variable) {}
  std::optional<clang::QualType> found;
  bool several = false;

  bool VisitCXXMemberCallExpr(clang::CXXMemberCallExpr* call) override {
    if (call->getMethodDecl() && variable_of(call->getImplicitObjectArgument()) == variable_)
      note(message_among(call->getMethodDecl()));
    return true;
  }
  bool VisitCallExpr(clang::CallExpr* call) override {
    const clang::FunctionDecl* function = call->getDirectCallee();
    const std::string name = function ? qualified_name_of(function) : "";
    if (name == "ros::SubscribeOptions::create" || name == "ros::AdvertiseOptions::create")
      note(message_among(function));
    return true;
  }

 private:
  void note(const std::optional<clang::QualType>& type) {
    if (!type) return;
    several = several || (found && found->getCanonicalType() != type->getCanonicalType());
    found = type;
  }
  const clang::VarDecl* variable_;
};

}  // namespace

std::optional<clang::QualType> options_message(const Unit& unit, const clang::Expr* options) {
  const clang::VarDecl* variable = variable_of(options);
  const clang::FunctionDecl* function = variable ? enclosing_function(unit.ast(), *options) : nullptr;
  if (!function || !function->getBody()) return {};
  OptionsVisitor visitor(variable);
  visitor.TraverseStmt(function->getBody());
  return visitor.several ? std::nullopt : visitor.found;
}

}  // namespace tzc::rewriter
