// SPDX-License-Identifier: BSD-3-Clause
#include "facts/syntax/unit.h"

#include <clang/AST/Attr.h>
#include <clang/Basic/CharInfo.h>
#include <llvm/ADT/STLExtras.h>
#include <llvm/Support/FileSystem.h>

#include "facts/syntax/bodies.h"
#include "facts/syntax/message_type.h"

namespace tzc::rewriter {
namespace {

bool has_macro(const clang::Stmt* stmt) {
  if (!stmt) return false;
  const auto* expr = llvm::dyn_cast<clang::Expr>(stmt);
  return stmt->getBeginLoc().isMacroID() || stmt->getEndLoc().isMacroID() ||
         (expr && expr->getExprLoc().isMacroID()) || llvm::any_of(stmt->children(), has_macro);
}

}  // namespace

bool Unit::declares(const clang::FunctionDecl* function) const {
  return function && source.in_package(pattern_of(function)->getLocation());
}

bool Unit::declares_all_of(const clang::FunctionDecl* function) const {
  if (!declares(function) || function->getMostRecentDecl()->hasDefiningAttr() ||
      may_have_another_body(function))
    return false;
  const auto* method = llvm::dyn_cast<clang::CXXMethodDecl>(function);
  if (!method || !method->isVirtual()) return true;
  return method->hasAttr<clang::FinalAttr>() || method->getParent()->isEffectivelyFinal() ||
         !exports(method->getParent()->getLocation());
}

bool Unit::exports(clang::SourceLocation location) const {
  const std::string& file = source.file_of(location);
  return llvm::any_of(
      exported_dirs, [&](const std::string& path) { return file == path || file.rfind(path + "/", 0) == 0; });
}

bool Unit::exports(const clang::FunctionDecl* function) const {
  const clang::FunctionDecl* first = pattern_of(function)->getFirstDecl();
  const auto* method = llvm::dyn_cast<clang::CXXMethodDecl>(first);
  const bool is_hidden = first->getAccess() == clang::AS_private && !(method && method->isVirtual());
  return !is_hidden && exports(first->getLocation());
}

bool Unit::has_twin(const std::string& message) const {
  return llvm::any_of(include_dirs, [&](const std::string& dir) {
    return llvm::sys::fs::exists(dir + "/" + twin_header(message));
  });
}

std::string Unit::squeezed(const clang::Stmt* stmt) const {
  if (has_macro(stmt)) return "";
  std::string result = text(stmt);
  llvm::erase_if(result, [](char c) { return clang::isWhitespace(c); });
  return result;
}

}  // namespace tzc::rewriter
