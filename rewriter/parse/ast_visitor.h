// SPDX-License-Identifier: BSD-3-Clause
// Clang's RecursiveASTVisitor with virtual functions, for the nodes that this project visits: the template is instantiated
// once, which takes the compiler longer than all that its visitors do. LLVM 20 has the same (DynamicRecursiveASTVisitor).
#pragma once

#include <clang/AST/DeclCXX.h>
#include <clang/AST/ExprCXX.h>
#include <clang/AST/ExprConcepts.h>
#include <clang/AST/StmtCXX.h>
#include <clang/AST/TypeLoc.h>

namespace tzc::rewriter {

/// Walks a declaration or statement and all that it holds. A visitor overrides what it wants to see and returns whether the
/// walk goes on.
class AstVisitor {
 public:
  virtual ~AstVisitor() = default;

  /// All that is in the unit's traversal scope.
  bool TraverseAST(clang::ASTContext& ast);
  bool TraverseDecl(clang::Decl* decl);
  bool TraverseStmt(clang::Stmt* stmt);

  virtual bool shouldVisitTemplateInstantiations() const { return false; }
#define TZC_NODE(kind) \
  virtual bool Visit##kind(clang::kind*) { return true; }
#include "parse/ast_visitor.def"
#undef TZC_NODE
  virtual bool VisitDecltypeTypeLoc(clang::DecltypeTypeLoc) { return true; }
  virtual bool VisitDependentNameTypeLoc(clang::DependentNameTypeLoc) { return true; }
  virtual bool VisitTemplateSpecializationTypeLoc(clang::TemplateSpecializationTypeLoc) { return true; }
};

}  // namespace tzc::rewriter
