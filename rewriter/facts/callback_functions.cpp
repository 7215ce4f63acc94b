// SPDX-License-Identifier: BSD-3-Clause
#include "facts/callback_functions.h"

#include <clang/AST/DeclTemplate.h>
#include <clang/AST/ExprCXX.h>

#include <set>

namespace tzc::rewriter {
namespace {

class CallbackSearch {
 public:
  explicit CallbackSearch(const Unit& unit) : unit_(unit) {}

  void in(const clang::Stmt* stmt) {
    if (!stmt) return;
    if (const auto* lambda = llvm::dyn_cast<clang::LambdaExpr>(stmt))
      return of_object(lambda->getLambdaClass());
    if (const auto* made = llvm::dyn_cast<clang::CXXConstructExpr>(stmt))
      of_object(made->getConstructor()->getParent());
    if (const auto* name = llvm::dyn_cast<clang::DeclRefExpr>(stmt)) of_name(name->getDecl());
    if (const auto* member = llvm::dyn_cast<clang::MemberExpr>(stmt))
      has_unknown |=
          llvm::isa<clang::FieldDecl>(member->getMemberDecl()) && may_hold_function(member->getType());
    for (const clang::Stmt* child : stmt->children()) in(child);
  }
  std::vector<const clang::FunctionDecl*> found;
  bool has_unknown = false;

 private:
  /// What a parameter, a member or a variable that is set later leads to.
  static bool may_hold_function(clang::QualType type) {
    type = type.getNonReferenceType().getCanonicalType();
    if (type->isFunctionPointerType() || type->isMemberFunctionPointerType()) return true;
    const clang::CXXRecordDecl* record = type->getAsCXXRecordDecl();
    return record && record->getIdentifier() && record->getName() == "function";
  }
  void of_name(const clang::ValueDecl* named) {
    if (const auto* function = llvm::dyn_cast<clang::FunctionDecl>(named)) found.push_back(function);
    const auto* variable = llvm::dyn_cast<clang::VarDecl>(named);
    if (!variable || !seen_.insert(variable).second) return;
    of_object(variable->getType().getNonReferenceType()->getAsCXXRecordDecl());
    const bool is_set_here = !llvm::isa<clang::ParmVarDecl>(variable) && variable->getInit();
    has_unknown |= may_hold_function(variable->getType()) && !is_set_here;
    in(variable->getInit());
  }

  /// Its call operators; of a generic one the instances.
  void of_object(const clang::CXXRecordDecl* record) {
    if (!record || !record->hasDefinition() || !unit_.source.in_package(record->getLocation())) return;
    const clang::DeclarationName name = unit_.ast().DeclarationNames.getCXXOperatorName(clang::OO_Call);
    for (const clang::NamedDecl* decl : record->lookup(name)) {
      if (const auto* function = llvm::dyn_cast<clang::FunctionDecl>(decl)) found.push_back(function);
      if (const auto* pattern = llvm::dyn_cast<clang::FunctionTemplateDecl>(decl))
        for (const clang::FunctionDecl* instance : pattern->specializations()) found.push_back(instance);
    }
  }

  const Unit& unit_;
  std::set<const clang::VarDecl*> seen_;
};

}  // namespace

bool calls_unknown_functions(const Unit& unit, const clang::Stmt* argument) {
  CallbackSearch search(unit);
  search.in(argument);
  return search.has_unknown;
}

std::vector<const clang::FunctionDecl*> callback_functions(const Unit& unit, const clang::Stmt* argument) {
  CallbackSearch search(unit);
  search.in(argument);
  return std::move(search.found);
}

}  // namespace tzc::rewriter
