// SPDX-License-Identifier: BSD-3-Clause
#include "verify/callees.h"

#include <set>
#include <utility>

#include "parse/ast_visitor.h"
#include "parse/names.h"
#include "parse/source.h"

namespace tzc::rewriter {
namespace {

/// Offset in a file, and in the macros around it: edits keep the order.
using Position = std::pair<unsigned, std::vector<unsigned>>;

class Calls : public AstVisitor {
 public:
  explicit Calls(const Source& source) : source_(source), instances_(source) {}
  bool shouldVisitTemplateInstantiations() const override { return true; }
  std::vector<PackageCall> calls;

  /// When all functions are known.
  void number_callees() {
    std::map<std::string, std::map<Position, unsigned>> numbers;
    for (const auto& [file, positions] : functions_)
      for (const Position& position : positions)
        numbers[file].emplace(position, static_cast<unsigned>(numbers[file].size()));
    for (const auto& [call, position] : callees_) {
      const auto& known = numbers[calls[call].callee_file];
      const auto at = known.lower_bound(position);
      calls[call].callee_number = at == known.end() ? static_cast<unsigned>(known.size()) : at->second;
    }
  }

  bool VisitFunctionDecl(clang::FunctionDecl* function) override {
    enter(function);
    const clang::SourceLocation where = function->getLocation();
    note_function(function);
    return here_->pattern.empty() || !source_.in_package(where) ||
           note_call(source_.where(where), "", 0, function);
  }
  bool VisitFieldDecl(clang::FieldDecl* field) override { return enter(field->getParent()); }
  bool VisitVarDecl(clang::VarDecl* variable) override {
    return variable->isLocalVarDeclOrParm() || enter(variable->getDeclContext());
  }

  /// What a generic closure's parameters decide is in its instances, which no walk enters by itself.
  bool VisitLambdaExpr(clang::LambdaExpr* lambda) override {
    note_function(lambda->getCallOperator());
    const clang::FunctionTemplateDecl* generic = lambda->getDependentCallOperator();
    if (!generic) return true;
    const Instance* around = here_;
    for (clang::FunctionDecl* instance : generic->specializations()) TraverseDecl(instance);
    here_ = around;
    return true;
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
    here_ = &instances_.of(context);
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
    note_call(source_.where(where), callee.file, callee.line, function);
    callees_.emplace_back(calls.size() - 1, position_of(pattern));
    return true;
  }
  bool note_call(const Place& at, const std::string& callee_file, unsigned callee_line,
                 const clang::FunctionDecl* callee) {
    calls.push_back(
        {at.file, at.line, callee_file, callee_line, instances_.qualified_name_of(callee), *here_});
    return true;
  }
  /// Redeclarations are functions of their own here, instances stand where their pattern does. What the compiler adds to a class it adds when
  /// something needs it, or when a member's type has to be looked at: a port may change both.
  void note_function(const clang::FunctionDecl* function) {
    const clang::SourceLocation where = function->getLocation();
    if (function->isImplicit()) return;
    if (source_.in_package(where)) functions_[source_.where(where).file].insert(position_of(function));
  }
  /// Of what it begins with: its name may be what a macro was given for several.
  Position position_of(const clang::FunctionDecl* function) const {
    const clang::SourceLocation begin = function->getBeginLoc();
    return {source_.where(begin).begin, source_.offsets_in_macros(begin)};
  }
  const Source& source_;
  Instances instances_;
  const Instance* here_ = &instances_.of(nullptr);
  std::map<std::string, std::set<Position>> functions_;    ///< by file
  std::vector<std::pair<std::size_t, Position>> callees_;  ///< of the calls with these indices
};

}  // namespace

std::vector<PackageCall> package_calls(clang::ASTContext& ast, const FolderSet& packages) {
  const Source source(ast, packages);
  Calls visitor(source);
  for (clang::Decl* decl : ast.getTranslationUnitDecl()->decls())
    if (source.in_package(decl->getLocation())) visitor.TraverseDecl(decl);
  visitor.number_callees();
  return std::move(visitor.calls);
}

}  // namespace tzc::rewriter
