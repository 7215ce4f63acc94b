// SPDX-License-Identifier: BSD-3-Clause
#include "facts/syntax/bodies.h"

#include <clang/AST/Attr.h>
#include <llvm/ADT/STLExtras.h>

#include "parse/names.h"

namespace tzc::rewriter {
namespace {

/// A declaration anywhere in the unit makes the function weak.
bool is_replaceable(const clang::FunctionDecl* function) {
  const bool has_versions = function->isMultiVersion() && !function->isTargetClonesMultiVersion();
  return has_versions || llvm::any_of(function->redecls(), [](const clang::Decl* declaration) {
           return declaration->hasAttr<clang::WeakAttr>() || declaration->hasAttr<clang::GNUInlineAttr>();
         });
}

}  // namespace

bool may_have_another_body(const clang::FunctionDecl* function) {
  return is_replaceable(function) || is_replaceable(pattern_of(function));
}

const clang::FunctionDecl* shown_body(const clang::FunctionDecl* function) {
  const clang::FunctionDecl* definition = nullptr;
  return function->isDefined(definition) && definition->getBody() && !may_have_another_body(function)
             ? definition
             : nullptr;
}

}  // namespace tzc::rewriter
