// SPDX-License-Identifier: BSD-3-Clause
#include "facts/collect_unit.h"

#include <clang/AST/ASTContext.h>

#include "facts/collect.h"
#include "parse/ast_visitor.h"

namespace tzc::rewriter {
namespace {

/// The files of the packages that the unit includes.
std::set<std::string> files_of(const Unit& unit, const CollectOptions& options) {
  std::set<std::string> files;
  const clang::SourceManager& manager = unit.source.manager();
  // Iterates over the places where files were entered: searching them for each file would take quadratic
  // time.
  for (unsigned i = 1; i < manager.local_sloc_entry_size(); ++i) {
    const clang::SrcMgr::SLocEntry& entry = manager.getLocalSLocEntry(i);
    if (!entry.isFile()) continue;
    const std::string path =
        unit.source.file_of(clang::SourceLocation::getFromRawEncoding(entry.getOffset()));
    if (options.packages.hold(path) && !options.generated.hold(path)) files.insert(path);
  }
  return files;
}

/// Makes templates fit for being read: finds the instances of generic lambdas, which no other declaration leads to, and gives the
/// lists in parentheses of dependent initializers a type, since Clang leaves them without one and each other expression has one.
class Templates : public AstVisitor {
 public:
  Templates(clang::ASTContext& ast, std::vector<clang::Decl*>& found) : ast_(ast), found_(found) {}
  bool shouldVisitTemplateInstantiations() const override { return true; }
  bool VisitStmt(clang::Stmt* stmt) override {
    auto* const expr = llvm::dyn_cast<clang::Expr>(stmt);
    if (expr && expr->getType().isNull()) expr->setType(ast_.DependentTy);
    return true;
  }
  bool VisitLambdaExpr(clang::LambdaExpr* lambda) override {
    const clang::FunctionTemplateDecl* pattern = lambda->getLambdaClass()->getDependentLambdaCallOperator();
    if (!pattern || !lambda->isGenericLambda()) return true;
    for (clang::FunctionDecl* instance : pattern->specializations())
      if (instance->hasBody() && !llvm::is_contained(found_, instance)) {
        found_.push_back(instance);
        TraverseDecl(instance);
      }
    return true;
  }

 private:
  clang::ASTContext& ast_;
  std::vector<clang::Decl*>& found_;
};

/// The declarations of the package alone: the parents of system headers are of no interest, and there are
/// many.
void limit_to_package(const Unit& unit) {
  std::vector<clang::Decl*> own;
  for (clang::Decl* decl : unit.ast().getTranslationUnitDecl()->decls())
    if (unit.source.in_package(decl->getLocation())) own.push_back(decl);
  std::vector<clang::Decl*> instances;
  Templates visitor(unit.ast(), instances);
  for (clang::Decl* decl : own) visitor.TraverseDecl(decl);
  own.insert(own.end(), instances.begin(), instances.end());
  unit.ast().setTraversalScope(own);
}

/// Where the unit finds headers, TZC's among them.
std::vector<std::string> include_dirs_of(const CompileUnit& unit, const CollectOptions& options) {
  std::vector<std::string> dirs = options.include_dirs;
  const auto add = [&](const std::string& dir) {
    dirs.push_back(dir[0] == '/' ? dir : unit.directory + "/" + dir);
  };
  for (std::size_t i = 0; i < unit.arguments.size(); ++i) {
    const std::string& argument = unit.arguments[i];
    const bool last = i + 1 == unit.arguments.size();
    if (argument.rfind("-I", 0) == 0 && argument.size() > 2)
      add(argument.substr(2));
    else if (!last && (argument == "-I" || argument == "-isystem" || argument == "-idirafter"))
      add(unit.arguments[i + 1]);
  }
  dirs.insert(dirs.end(), {"/usr/local/include", "/usr/include"});
  return dirs;
}

}  // namespace

Facts collect_unit(clang::ASTContext& ast, const CompileUnit& unit, const CollectOptions& options) {
  const Unit parsed{Source(ast, options.packages),  *options.rules,  options.exported_dirs,
                    include_dirs_of(unit, options), options.trusted, options.layouts_stay};
  limit_to_package(parsed);
  Facts facts = collect(parsed);
  for (const std::string& file : files_of(parsed, options)) facts.units_of_file[file].insert(unit.file);
  return facts;
}

}  // namespace tzc::rewriter
