// SPDX-License-Identifier: BSD-3-Clause
#include "facts/sites/callback_functions.h"

#include <clang/AST/DeclTemplate.h>
#include <clang/AST/ExprCXX.h>

#include <set>

#include "facts/sites/later_writes.h"
#include "facts/syntax/calls.h"

namespace tzc::rewriter {
namespace {

/// Function pointers, std::function and boost::function, and containers of such.
bool may_hold_function(clang::QualType type) {
  type = type.getNonReferenceType().getCanonicalType();
  if (const clang::ArrayType* array = type->getAsArrayTypeUnsafe())
    return may_hold_function(array->getElementType());
  if (type->isFunctionPointerType() || type->isMemberFunctionPointerType()) return true;
  const clang::CXXRecordDecl* record = type->getAsCXXRecordDecl();
  if (!record || !record->getIdentifier()) return false;
  if (record->getName() == "function") return true;
  const auto* made = llvm::dyn_cast<clang::ClassTemplateSpecializationDecl>(record);
  return made && llvm::any_of(made->getTemplateArgs().asArray(), [](const clang::TemplateArgument& argument) {
           return argument.getKind() == clang::TemplateArgument::Type &&
                  may_hold_function(argument.getAsType());
         });
}

/// Whether a variable begins with a function: an object made of nothing has none.
bool begins_with_function(const clang::VarDecl* variable) {
  if (llvm::isa<clang::ParmVarDecl>(variable) || !variable->getInit()) return false;
  const auto* made = llvm::dyn_cast<clang::CXXConstructExpr>(variable->getInit()->IgnoreImplicit());
  return !made || made->getNumArgs() > 0;
}

/// bind(function, _1, 5) and its like: the object calls what is among the arguments, and those are searched anyway.
bool wraps_call(const clang::FunctionDecl* function) {
  static const std::set<std::string> names = {"std::bind",        "boost::bind",     "std::mem_fn",
                                              "boost::mem_fn",    "std::bind_front", "boost::protect",
                                              "boost::bind_front"};
  return names.count(qualified_name_of(function)) != 0;
}

/// +[](const M&) {}: a closure as a pointer to its function.
bool converts_closure(const clang::FunctionDecl* function) {
  const auto* conversion = llvm::dyn_cast<clang::CXXConversionDecl>(function);
  return conversion && conversion->getParent()->isLambda();
}

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
    if (const auto* call = llvm::dyn_cast<clang::CallExpr>(stmt)) of_call(call);
    if (const auto* member = llvm::dyn_cast<clang::MemberExpr>(stmt))
      has_unknown |=
          llvm::isa<clang::FieldDecl>(member->getMemberDecl()) && may_hold_function(member->getType());
    for (const clang::Stmt* child : stmt->children())
      if (!is_called_name(stmt, child)) in(child);
  }
  std::vector<const clang::FunctionDecl*> found;
  bool has_unknown = false;

 private:
  /// boost::bind(...): it is called here, and not when a message comes.
  static bool is_called_name(const clang::Stmt* stmt, const clang::Stmt* child) {
    const auto* call = llvm::dyn_cast<clang::CallExpr>(stmt);
    return call && child == call->getCallee() &&
           llvm::isa<clang::DeclRefExpr>(call->getCallee()->IgnoreParenImpCasts());
  }
  /// What another package may override, or has, may do anything.
  void of_name(const clang::ValueDecl* named) {
    if (const auto* function = llvm::dyn_cast<clang::FunctionDecl>(named)) {
      found.push_back(function);
      has_unknown |= !unit_.declares_all_of(function);
    }
    const auto* variable = llvm::dyn_cast<clang::VarDecl>(named);
    if (!variable || !seen_.insert(variable).second) return;
    of_object(variable->getType().getNonReferenceType()->getAsCXXRecordDecl());
    has_unknown |= may_hold_function(variable->getType()) &&
                   (!begins_with_function(variable) || may_change_later(variable));
    in(variable->getInit());
  }
  /// A function may return any function, one of the package also a closure. So may one that is called through a pointer.
  void of_call(const clang::CallExpr* call) {
    const clang::FunctionDecl* function = call->getDirectCallee();
    const bool hands_on = function && (passes_through(function) || wraps_call(function));
    if (function && converts_closure(function))
      return of_object(llvm::cast<clang::CXXConversionDecl>(function)->getParent());
    has_unknown |= may_hold_function(call->getType()) && !hands_on;
    if (!function || !unit_.declares(function)) return;
    of_object(call->getType().getNonReferenceType()->getAsCXXRecordDecl());
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
