// SPDX-License-Identifier: BSD-3-Clause
#include "verify/callees.h"

#include <clang/AST/DeclTemplate.h>
#include <llvm/Support/raw_ostream.h>

#include <map>

#include "parse/ast_visitor.h"
#include "parse/names.h"
#include "parse/source.h"

namespace tzc::rewriter {
namespace {

/// The template arguments of a function or class that is an instantiation; null: it is none.
const clang::TemplateArgumentList* instantiated_with(const clang::DeclContext* context) {
  if (const auto* function = llvm::dyn_cast<clang::FunctionDecl>(context))
    return function->isTemplateInstantiation() ? function->getTemplateSpecializationArgs() : nullptr;
  const auto* record = llvm::dyn_cast<clang::ClassTemplateSpecializationDecl>(context);
  const bool is_written = !record || record->isExplicitSpecialization();
  return is_written ? nullptr : &record->getTemplateArgs();
}

std::string text_of(const clang::TemplateArgumentList& arguments, const clang::ASTContext& ast) {
  std::string text;
  llvm::raw_string_ostream stream(text);
  for (const clang::TemplateArgument& argument : arguments.asArray()) {
    ast.getCanonicalTemplateArgument(argument).print(ast.getPrintingPolicy(), stream, true);
    stream << ';';
  }
  return text;
}

std::string name_of(const clang::DeclContext* context) {
  const auto* named = llvm::dyn_cast<clang::NamedDecl>(context);
  const auto* function = llvm::dyn_cast<clang::FunctionDecl>(context);
  return (named ? named->getNameAsString() : "") +
         (function ? "/" + std::to_string(function->getNumParams()) : "") + "::";
}

Instance instance_of(const clang::DeclContext* context, const clang::ASTContext& ast) {
  Instance instance;
  for (; context; context = context->getParent()) {
    instance.pattern = name_of(context) + instance.pattern;
    if (const clang::TemplateArgumentList* arguments = instantiated_with(context))
      instance.arguments = text_of(*arguments, ast) + instance.arguments;
  }
  return instance.arguments.empty() ? Instance() : instance;
}

class Calls : public AstVisitor {
 public:
  explicit Calls(const Source& source) : source_(source) {}
  bool shouldVisitTemplateInstantiations() const override { return true; }
  std::vector<PackageCall> calls;

  bool VisitFunctionDecl(clang::FunctionDecl* function) override {
    enter(function);
    const clang::SourceLocation where = function->getLocation();
    return here_->pattern.empty() || !source_.in_package(where) ||
           note_call(source_.where(where), "", 0, function);
  }
  bool VisitFieldDecl(clang::FieldDecl* field) override { return enter(field->getParent()); }
  bool VisitVarDecl(clang::VarDecl* variable) override {
    return variable->isLocalVarDeclOrParm() || enter(variable->getDeclContext());
  }

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
  /// What is visited next is part of this function, or of this class or namespace.
  bool enter(const clang::DeclContext* context) {
    const auto known = instances_.find(context);
    here_ = known != instances_.end()
                ? &known->second
                : &instances_.emplace(context, instance_of(context, source_.ast())).first->second;
    return true;
  }
  /// std::vector<bool>{first, last} of iterators is a range; of pointers it is a list of two elements.
  bool note_list(const clang::CXXConstructExpr* construct) {
    const clang::SourceLocation where = construct->getExprLoc();
    if (!construct->isStdInitListInitialization() || !source_.in_package(where)) return true;
    return note_call(source_.where(where), "", 0, construct->getConstructor());
  }
  bool note(clang::SourceLocation where, const clang::FunctionDecl* function) {
    const clang::FunctionDecl* pattern = pattern_of(function);
    if (!source_.in_package(where) || !source_.in_package(pattern->getLocation())) return true;
    const Place callee = source_.where(pattern->getLocation());
    return note_call(source_.where(where), callee.file, callee.line, function);
  }
  bool note_call(const Place& at, const std::string& callee_file, unsigned callee_line,
                 const clang::FunctionDecl* callee) {
    calls.push_back({at.file, at.line, callee_file, callee_line, qualified_name_of(callee), *here_});
    return true;
  }
  const Source& source_;
  std::map<const clang::DeclContext*, Instance> instances_ = {{nullptr, {}}};
  const Instance* here_ = &instances_.at(nullptr);
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
