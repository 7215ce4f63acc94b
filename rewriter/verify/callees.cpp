// SPDX-License-Identifier: BSD-3-Clause
#include "verify/callees.h"

#include "parse/ast_visitor.h"
#include "parse/names.h"
#include "parse/source.h"

namespace tzc::rewriter {
namespace {

class Calls : public AstVisitor {
 public:
  explicit Calls(const Source& source) : source_(source) {}
  bool shouldVisitTemplateInstantiations() const override { return true; }
  std::vector<PackageCall> calls;

  bool VisitCallExpr(clang::CallExpr* call) override {
    const clang::FunctionDecl* function = call->getDirectCallee();
    return !function || note(call->getExprLoc(), function);
  }
  bool VisitCXXConstructExpr(clang::CXXConstructExpr* construct) override {
    const clang::CXXConstructorDecl* constructor = construct->getConstructor();
    return note_list(construct) && (constructor->isImplicit() || constructor->isCopyOrMoveConstructor() ||
                                    note(construct->getExprLoc(), constructor));
  }

 private:
  /// std::vector<bool>{first, last} of iterators is a range; of pointers it is a list of two elements.
  bool note_list(const clang::CXXConstructExpr* construct) {
    const clang::SourceLocation where = construct->getExprLoc();
    if (!construct->isStdInitListInitialization() || !source_.in_package(where)) return true;
    const Place at = source_.where(where);
    calls.push_back({at.file, at.line, "", 0, qualified_name_of(construct->getConstructor())});
    return true;
  }
  bool note(clang::SourceLocation where, const clang::FunctionDecl* function) {
    const clang::FunctionDecl* pattern = pattern_of(function);
    if (!source_.in_package(where) || !source_.in_package(pattern->getLocation())) return true;
    const Place call = source_.where(where), callee = source_.where(pattern->getLocation());
    calls.push_back({call.file, call.line, callee.file, callee.line, qualified_name_of(function)});
    return true;
  }
  const Source& source_;
};

}  // namespace

std::vector<PackageCall> package_calls(clang::ASTContext& ast, const FolderSet& packages) {
  const Source source(ast, packages);
  Calls visitor(source);
  for (clang::Decl* decl : ast.getTranslationUnitDecl()->decls())
    if (source.in_package(decl->getLocation())) visitor.TraverseDecl(decl);
  return std::move(visitor.calls);
}

}  // namespace tzc::rewriter
