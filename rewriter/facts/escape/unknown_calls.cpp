// SPDX-License-Identifier: BSD-3-Clause
#include "facts/escape/unknown_calls.h"

#include <clang/AST/Attr.h>
#include <clang/AST/StmtCXX.h>

namespace tzc::rewriter {

namespace {

template <class Key>
void add(std::map<Key, IfShown>& calls, Key key, const IfShown& call) {
  const auto [known, is_new] = calls.emplace(key, call);
  if (!is_new) known->second = *either(known->second, call);
}

}  // namespace

UnknownCalls::UnknownCalls(const std::vector<SeenEvent>& events) {
  for (const SeenEvent& seen : events) {
    if (seen.event.kind != PublishEvent::Kind::unknown) continue;
    const auto* declaration = llvm::dyn_cast<clang::DeclStmt>(seen.at);
    if (const auto* handler = llvm::dyn_cast<clang::CXXCatchStmt>(seen.at))
      add<const clang::VarDecl*>(ends_, handler->getExceptionDecl(), seen.event.if_shown);
    if (!declaration) {
      add(calls_, seen.at, seen.event.if_shown);
      continue;
    }
    for (const clang::Decl* decl : declaration->decls())
      if (const auto* variable = llvm::dyn_cast<clang::VarDecl>(decl)) {
        add(ends_, variable, seen.event.if_shown);
        at_end_of_scopes_ |= variable->hasAttr<clang::CleanupAttr>();
      }
  }
}

}  // namespace tzc::rewriter
