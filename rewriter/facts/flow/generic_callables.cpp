// SPDX-License-Identifier: BSD-3-Clause
#include "facts/flow/generic_callables.h"

#include <clang/AST/DeclTemplate.h>

#include <set>

namespace tzc::rewriter {
namespace {

/// Finds out whether an object of a type, or what such an object is made of, takes arguments of any type.
class TakesAnything {
 public:
  explicit TakesAnything(const Unit& unit) : unit_(unit) {}

  bool type(clang::QualType of) {
    if (of.isNull()) return false;
    of = of.getNonReferenceType().getCanonicalType();
    if (!seen_.insert(of.getTypePtr()).second) return false;  // it is being looked at, or was
    if (of->isPointerType()) return type(of->getPointeeType());
    if (const auto* function = of->getAs<clang::FunctionProtoType>())
      return llvm::any_of(function->param_types(),
                          [&](clang::QualType parameter) { return type(parameter); });
    const clang::CXXRecordDecl* record = of->getAsCXXRecordDecl();
    const auto* made = llvm::dyn_cast_or_null<clang::ClassTemplateSpecializationDecl>(record);
    if (!record || !record->hasDefinition()) return false;
    return (!record->isInStdNamespace() && takes(record)) ||
           llvm::any_of(record->bases(), [&](const auto& base) { return type(base.getType()); }) ||
           (made && any_argument(made->getTemplateArgs().asArray()));
  }

 private:
  /// std::less<> and its like read what they are given.
  bool takes(const clang::CXXRecordDecl* record) {
    return llvm::any_of(record->decls(), [&](const clang::Decl* member) {
      if (const auto* pattern = llvm::dyn_cast<clang::FunctionTemplateDecl>(member))
        return is_call(pattern->getTemplatedDecl()) ||
               (llvm::isa<clang::CXXConstructorDecl>(pattern->getTemplatedDecl()) &&
                unit_.source.in_package(record->getLocation()));
      const auto* method = llvm::dyn_cast<clang::CXXMethodDecl>(member);
      return method && is_call(method) && type(method->getType());
    });
  }
  static bool is_call(const clang::FunctionDecl* function) {
    return function->getDeclName().getCXXOverloadedOperator() == clang::OO_Call;
  }
  bool any_argument(llvm::ArrayRef<clang::TemplateArgument> arguments) {
    return llvm::any_of(arguments, [&](const clang::TemplateArgument& argument) {
      if (argument.getKind() == clang::TemplateArgument::Type) return type(argument.getAsType());
      return argument.getKind() == clang::TemplateArgument::Pack && any_argument(argument.pack_elements());
    });
  }
  const Unit& unit_;
  std::set<const clang::Type*> seen_;
};

/// They put their arguments into an object, or take one out, and call nothing.
bool only_keeps(const clang::FunctionDecl* callee) {
  static const std::set<std::string> names = {"std::make_pair", "std::make_tuple", "std::tie",
                                              "std::forward_as_tuple", "std::get"};
  return names.count(qualified_name_of(callee)) != 0;
}

bool any_takes_anything(const Unit& unit, llvm::ArrayRef<const clang::Expr*> arguments) {
  return llvm::any_of(arguments, [&](const clang::Expr* argument) {
    return TakesAnything(unit).type(argument->IgnoreParenImpCasts()->getType());
  });
}

}  // namespace

bool may_call_generic_code(const Unit& unit, const clang::CallExpr* call) {
  const clang::FunctionDecl* callee = call->getDirectCallee();
  if (!callee || unit.declares(callee) || only_keeps(callee)) return false;
  const auto* method = llvm::dyn_cast<clang::CXXMethodDecl>(callee);
  const bool by_object = method && TakesAnything(unit).type(unit.ast().getRecordType(method->getParent()));
  return by_object || TakesAnything(unit).type(call->getType()) ||
         any_takes_anything(unit, {call->getArgs(), call->getNumArgs()});
}

bool may_call_generic_code(const Unit& unit, const clang::CXXConstructExpr* construct) {
  if (unit.declares(construct->getConstructor())) return false;
  return TakesAnything(unit).type(construct->getType()) ||
         any_takes_anything(unit, {construct->getArgs(), construct->getNumArgs()});
}

}  // namespace tzc::rewriter
