// SPDX-License-Identifier: BSD-3-Clause
#include "verify/instances.h"

#include <clang/AST/DeclTemplate.h>
#include <llvm/Support/raw_ostream.h>

#include "edits/files.h"

namespace tzc::rewriter {
namespace {

/// Whether Clang goes on to print where types without a name stand.
bool print_places(clang::ASTContext& ast, bool are_printed) {
  clang::PrintingPolicy policy = ast.getPrintingPolicy();
  const bool before = policy.AnonymousTagLocations;
  policy.AnonymousTagLocations = are_printed;
  ast.setPrintingPolicy(policy);
  return before;
}

/// The template arguments of a function or class that is an instantiation; null: it is none.
const clang::TemplateArgumentList* instantiated_with(const clang::DeclContext* context) {
  if (const auto* function = llvm::dyn_cast<clang::FunctionDecl>(context))
    return function->isTemplateInstantiation() ? function->getTemplateSpecializationArgs() : nullptr;
  const auto* record = llvm::dyn_cast<clang::ClassTemplateSpecializationDecl>(context);
  const bool is_written = !record || record->isExplicitSpecialization();
  return is_written ? nullptr : &record->getTemplateArgs();
}

bool is_left_out(const clang::DeclContext* context) {
  const auto* space = llvm::dyn_cast<clang::NamespaceDecl>(context);
  return !llvm::isa<clang::NamedDecl>(context) ||
         (space && (space->isInline() || space->isAnonymousNamespace()));
}

}  // namespace

Instances::Instances(const Source& source)
    : source_(source), printed_places_(print_places(source.ast(), false)), unnamed_(source) {}

Instances::~Instances() {
  print_places(source_.ast(), printed_places_);
}

const Instance& Instances::of(const clang::DeclContext* context) {
  if (const auto known = known_.find(context); known != known_.end()) return known->second;
  known_[context] = {};  // for a type that is mentioned in its own context's arguments
  return known_[context] = found(context);
}

Instance Instances::found(const clang::DeclContext* context) {
  Instance instance;
  bool is_instance = false;
  for (; context; context = context->getParent()) {
    const auto* named = llvm::dyn_cast<clang::NamedDecl>(context);
    const auto* function = llvm::dyn_cast<clang::FunctionDecl>(context);
    const auto* type = llvm::dyn_cast<clang::TagDecl>(context);
    instance.pattern = (named ? name_of(named) : "") +
                       (function ? "/" + std::to_string(function->getNumParams()) : "") +
                       "::" + instance.pattern;
    if (type && is_unnamed(type)) instance.arguments = unnamed_.number_of(type) + ";" + instance.arguments;
    if (const clang::TemplateArgumentList* arguments = instantiated_with(context)) {
      instance.arguments = text_of(*arguments) + instance.arguments;
      is_instance = true;
    }
  }
  return is_instance ? instance : Instance();
}

std::string Instances::name_of(const clang::NamedDecl* decl) const {
  const auto* type = llvm::dyn_cast<clang::TagDecl>(decl);
  if (type && !type->getIdentifier()) {
    if (const clang::TypedefNameDecl* alias = type->getTypedefNameForAnonDecl())
      return alias->getNameAsString();
    const auto* record = llvm::dyn_cast<clang::CXXRecordDecl>(type);
    return record && record->isLambda() ? "(lambda)" : "(unnamed)";
  }
  std::string text;
  llvm::raw_string_ostream stream(text);
  decl->getDeclName().print(stream, source_.ast().getPrintingPolicy());
  return text;
}

std::string Instances::qualified_name_of(const clang::NamedDecl* decl) const {
  std::string name = name_of(decl);
  for (const clang::DeclContext* context = decl->getDeclContext(); context; context = context->getParent())
    if (!is_left_out(context)) name = name_of(llvm::cast<clang::NamedDecl>(context)) + "::" + name;
  return name;
}

std::string Instances::text_of(const clang::TemplateArgumentList& arguments) {
  const clang::ASTContext& ast = source_.ast();
  std::string text;
  llvm::raw_string_ostream stream(text);
  std::vector<clang::TemplateArgument> canonical;
  for (const clang::TemplateArgument& argument : arguments.asArray()) {
    canonical.push_back(ast.getCanonicalTemplateArgument(argument));
    canonical.back().print(ast.getPrintingPolicy(), stream, true);
    stream << ';';
  }
  for (const clang::TagDecl* type : unnamed_types_in(canonical)) stream << name_of_unnamed(type) << ';';
  return text;
}

/// Which instance of the code that holds it, too.
std::string Instances::name_of_unnamed(const clang::TagDecl* type) {
  const std::string& around = of(type->getDeclContext()).arguments;
  if (around.empty()) return unnamed_.number_of(type);
  // Two closures of one instance, given to one template, would otherwise make the name twice as long at each level.
  const bool is_long = around.size() > 4096;
  return unnamed_.number_of(type) + "<" + (is_long ? std::to_string(content_hash(around)) : around) + ">";
}

}  // namespace tzc::rewriter
