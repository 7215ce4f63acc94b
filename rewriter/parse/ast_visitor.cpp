// SPDX-License-Identifier: BSD-3-Clause
#include "parse/ast_visitor.h"

#include <clang/AST/RecursiveASTVisitor.h>

namespace tzc::rewriter {
namespace {

class Walk : public clang::RecursiveASTVisitor<Walk> {
 public:
  explicit Walk(AstVisitor& visitor) : visitor_(visitor) {}

  bool shouldVisitTemplateInstantiations() const { return visitor_.shouldVisitTemplateInstantiations(); }
#define TZC_NODE(kind) \
  bool Visit##kind(clang::kind* node) { return visitor_.Visit##kind(node); }
#include "parse/ast_visitor.def"
#undef TZC_NODE
  bool VisitDecltypeTypeLoc(clang::DecltypeTypeLoc place) { return visitor_.VisitDecltypeTypeLoc(place); }
  bool VisitDependentNameTypeLoc(clang::DependentNameTypeLoc place) {
    return visitor_.VisitDependentNameTypeLoc(place);
  }
  bool VisitTemplateSpecializationTypeLoc(clang::TemplateSpecializationTypeLoc place) {
    return visitor_.VisitTemplateSpecializationTypeLoc(place);
  }

 private:
  AstVisitor& visitor_;
};

}  // namespace

bool AstVisitor::TraverseAST(clang::ASTContext& ast) {
  return Walk(*this).TraverseAST(ast);
}

bool AstVisitor::TraverseDecl(clang::Decl* decl) {
  return Walk(*this).TraverseDecl(decl);
}

bool AstVisitor::TraverseStmt(clang::Stmt* stmt) {
  return Walk(*this).TraverseStmt(stmt);
}

}  // namespace tzc::rewriter
