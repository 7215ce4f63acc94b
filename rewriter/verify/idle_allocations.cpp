// SPDX-License-Identifier: BSD-3-Clause
#include "verify/idle_allocations.h"

#include <clang/AST/DeclTemplate.h>
#include <clang/AST/ExprCXX.h>
#include <llvm/ADT/STLExtras.h>

#include <set>

#include "parse/ast_visitor.h"
#include "parse/names.h"
#include "parse/source.h"

namespace tzc::rewriter {
namespace {

constexpr unsigned deepest_field = 6;

const clang::ClassTemplateSpecializationDecl* specialization_of(clang::QualType type) {
  return llvm::dyn_cast_or_null<clang::ClassTemplateSpecializationDecl>(
      type.getNonReferenceType()->getAsCXXRecordDecl());
}

/// pkg::Type_<std::allocator<void>>, as gencpp writes it.
bool is_stock(const clang::ClassTemplateSpecializationDecl* record) {
  return record && record->getName().ends_with("_") && record->hasDefinition() &&
         record->getTemplateArgs().size() == 1 &&
         record->getTemplateArgs()[0].getKind() == clang::TemplateArgument::Type;
}

bool has_arrays(const clang::ClassTemplateSpecializationDecl* message, unsigned depth = 0) {
  return llvm::any_of(message->fields(), [&](const clang::FieldDecl* field) {
    const auto* part = specialization_of(field->getType());
    if (part && part->isInStdNamespace() && part->getName() == "vector") return true;
    return is_stock(part) && depth < deepest_field && has_arrays(part, depth + 1);
  });
}

/// What allocate() is given, itself or by a pointer.
const clang::ClassTemplateSpecializationDecl* message_given(const clang::Expr* argument) {
  const auto* given = specialization_of(argument->getType());
  const bool is_pointer = given && given->getName() == "shared_ptr";
  return is_pointer && given->getTemplateArgs()[0].getKind() == clang::TemplateArgument::Type
             ? specialization_of(given->getTemplateArgs()[0].getAsType())
             : given;
}

class Allocations : public AstVisitor {
 public:
  explicit Allocations(const Source& source) : source_(source) {}
  bool shouldVisitTemplateInstantiations() const override { return true; }
  std::vector<IdleAllocation> idle;

  bool VisitCallExpr(clang::CallExpr* call) override {
    const clang::FunctionDecl* function = call->getDirectCallee();
    if (!function || call->getNumArgs() != 1 || !function->getIdentifier() ||
        function->getName() != "allocate" ||
        !llvm::StringRef(qualified_name_of(function)).starts_with("tzc::"))
      return true;
    const auto* message = message_given(call->getArg(0));
    if (!is_stock(message) || !has_arrays(message) || !source_.in_package(call->getExprLoc())) return true;
    const Place where = source_.where(call->getExprLoc());
    idle.push_back({where.file, where.line, qualified_name_of(message)});
    return true;
  }
  /// No other declaration leads to the instances of a generic one.
  bool VisitLambdaExpr(clang::LambdaExpr* lambda) override {
    const clang::FunctionTemplateDecl* pattern = lambda->getLambdaClass()->getDependentLambdaCallOperator();
    if (!pattern) return true;
    for (clang::FunctionDecl* instance : pattern->specializations())
      if (instance->hasBody() && seen_.insert(instance).second) TraverseStmt(instance->getBody());
    return true;
  }

 private:
  const Source& source_;
  std::set<const clang::FunctionDecl*> seen_;
};

}  // namespace

std::vector<IdleAllocation> idle_allocations(clang::ASTContext& ast, const FolderSet& packages) {
  const Source source(ast, packages);
  Allocations visitor(source);
  for (clang::Decl* decl : ast.getTranslationUnitDecl()->decls())
    if (source.in_package(decl->getLocation())) visitor.TraverseDecl(decl);
  return std::move(visitor.idle);
}

}  // namespace tzc::rewriter
