// SPDX-License-Identifier: BSD-3-Clause
#include "parse/names.h"

#include <clang/AST/Decl.h>
#include <clang/Index/USRGeneration.h>

namespace tzc::rewriter {
namespace {

/// What is known of std::vector holds for the class of the twins that is one.
std::string as_vector(std::string name) {
  static const std::string own = "tzc::MessageArray";
  const bool is_own =
      name.compare(0, own.size(), own) == 0 && (name.size() == own.size() || name[own.size()] == ':');
  return is_own ? name.replace(0, own.size(), "std::vector") : name;
}

}  // namespace

std::string qualified_name_of(const clang::NamedDecl* decl) {
  std::string name;
  for (const clang::DeclContext* context = decl->getDeclContext(); context && !context->isTranslationUnit();
       context = context->getParent()) {
    const auto* space = llvm::dyn_cast<clang::NamedDecl>(context);
    const auto* as_namespace = llvm::dyn_cast<clang::NamespaceDecl>(context);
    if (!space || (as_namespace && (as_namespace->isInline() || as_namespace->isAnonymousNamespace())))
      continue;
    name = space->getNameAsString() + "::" + name;
  }
  return as_vector(name + decl->getNameAsString());
}

std::string usr_of(const clang::Decl* decl) {
  llvm::SmallString<128> usr;
  clang::index::generateUSRForDecl(decl, usr);
  return usr.str().str();
}

const clang::FunctionDecl* pattern_of(const clang::FunctionDecl* function) {
  const clang::FunctionDecl* pattern = function->getTemplateInstantiationPattern();
  return (pattern ? pattern : function)->getCanonicalDecl();
}

}  // namespace tzc::rewriter
