// SPDX-License-Identifier: BSD-3-Clause
#include "facts/unknown_calls.h"

#include <clang/AST/Attr.h>
#include <clang/AST/StmtCXX.h>

namespace tzc::rewriter {

UnknownCalls::UnknownCalls(const std::vector<SeenEvent>& events) {
  for (const SeenEvent& seen : events) {
    if (seen.event.kind != PublishEvent::Kind::unknown) continue;
    const auto* declaration = llvm::dyn_cast<clang::DeclStmt>(seen.at);
    if (const auto* handler = llvm::dyn_cast<clang::CXXCatchStmt>(seen.at))
      ends_.insert(handler->getExceptionDecl());
    if (!declaration) {
      calls_.insert(seen.at);
      continue;
    }
    for (const clang::Decl* decl : declaration->decls())
      if (const auto* variable = llvm::dyn_cast<clang::VarDecl>(decl)) {
        ends_.insert(variable);
        at_end_of_scopes_ |= variable->hasAttr<clang::CleanupAttr>();
      }
  }
}

}  // namespace tzc::rewriter
