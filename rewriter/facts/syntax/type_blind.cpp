// SPDX-License-Identifier: BSD-3-Clause
#include "facts/syntax/type_blind.h"

#include <clang/AST/ExprCXX.h>
#include <clang/Basic/SourceManager.h>

#include <set>
#include <string>

#include "facts/syntax/bodies.h"
#include "parse/ast_visitor.h"

namespace tzc::rewriter {
namespace {

/// typename M::Ptr: a name in the argument itself. It either means the same, or does not compile.
bool is_of_parameter(const clang::NestedNameSpecifier* qualifier) {
  const clang::Type* type = qualifier ? qualifier->getAsType() : nullptr;
  return type && llvm::isa<clang::TemplateTypeParmType>(type);
}

/// std::iterator_traits<It>::value_type: the same for a class of iterators and for the pointer that takes its place.
bool is_of_iterator(const clang::NestedNameSpecifier* qualifier) {
  const clang::Type* type = qualifier ? qualifier->getAsType() : nullptr;
  const auto* made = type ? type->getAs<clang::TemplateSpecializationType>() : nullptr;
  const clang::TemplateDecl* name = made ? made->getTemplateName().getAsTemplateDecl() : nullptr;
  return name && name->getName() == "iterator_traits";
}

/// Whether the program has its own version of a class template for some types.
bool is_specialised(const clang::TemplateDecl* name) {
  const auto* pattern = llvm::dyn_cast_or_null<clang::ClassTemplateDecl>(name);
  if (!pattern) return false;
  const clang::SourceManager& manager = pattern->getASTContext().getSourceManager();
  const auto is_own = [&](const clang::ClassTemplateSpecializationDecl* made) {
    return !manager.isInSystemHeader(made->getLocation());
  };
  llvm::SmallVector<clang::ClassTemplatePartialSpecializationDecl*, 4> partial;
  const_cast<clang::ClassTemplateDecl*>(pattern)->getPartialSpecializations(partial);
  return llvm::any_of(partial, is_own) || llvm::any_of(pattern->specializations(), [&](const auto* made) {
           return made->isExplicitSpecialization() && is_own(made);
         });
}

/// Whether a class template keeps something for each type.
bool has_statics(const clang::TemplateDecl* name) {
  const auto* record = llvm::dyn_cast_or_null<clang::CXXRecordDecl>(name->getTemplatedDecl());
  const clang::CXXRecordDecl* definition = record ? record->getDefinition() : nullptr;
  return definition && llvm::any_of(definition->decls(), [](const clang::Decl* member) {
           const auto* variable = llvm::dyn_cast<clang::VarDecl>(member);
           return variable && !variable->isConstexpr();
         });
}

/// Of the standard library, or of the package in its manner.
bool names_trait(llvm::StringRef name) {
  static constexpr llvm::StringRef others[] = {"integral_constant", "bool_constant", "conditional",
                                               "negation",          "conjunction",   "disjunction"};
  return name.starts_with("is_") || name.starts_with("has_") || llvm::is_contained(others, name);
}

/// Library functions that do the same with a message as with its twin when a template gives them its type: they make, move or cast
/// an object, or tell what both have in common.
bool treats_alike(const clang::NamedDecl* function) {
  static const std::set<std::string> names = {"make_shared",
                                              "make_unique",
                                              "allocate_shared",
                                              "make_pair",
                                              "make_tuple",
                                              "forward",
                                              "move",
                                              "declval",
                                              "get",
                                              "swap",
                                              "min",
                                              "max",
                                              "bind",
                                              "ref",
                                              "cref",
                                              "static_pointer_cast",
                                              "begin",
                                              "end",
                                              "distance",
                                              "const_pointer_cast",
                                              "addressof",
                                              "advertise",
                                              "subscribe",
                                              "dynamic_pointer_cast",
                                              "datatype",
                                              "md5sum",
                                              "definition",
                                              "serializationLength",
                                              "serialize",
                                              "deserialize",
                                              "serializeMessage",
                                              "deserializeMessage",
                                              "lexical_cast",
                                              "count_if",
                                              "timeStamp",
                                              "header",
                                              "frameId"};
  return names.count(function->getNameAsString()) != 0;
}

bool is_dependent(const clang::TemplateArgumentLoc& argument) {
  return argument.getArgument().isDependent();
}

class TypeQuestions : public AstVisitor {
 public:
  explicit TypeQuestions(const Unit& unit) : unit_(unit) {}
  bool found = false;

  /// template <class M, int code = Code<M>::value, class Policy = PolicyOf<M>>
  void look_at_parameters(const clang::TemplateDecl* made_of) {
    in_parameters_ = true;
    if (made_of)
      for (clang::NamedDecl* parameter : made_of->getTemplateParameters()->asArray()) TraverseDecl(parameter);
    in_parameters_ = false;
  }

  /// template <class T> struct Box: one that the program has another version of for some types asks by its name alone.
  void look_at_class(const clang::ClassTemplateDecl* made_of) {
    look_at_parameters(made_of);
    note(has_statics(made_of) || is_specialised(made_of));
    look_into(made_of);
  }

  /// std::is_pointer<It>(), as a value or to choose a function by. Before Clang 19 std::is_pointer<It>::value in a method may be a
  /// member of its object.
  bool VisitStmt(clang::Stmt* stmt) override {
    if (llvm::isa<clang::CXXNoexceptExpr, clang::RequiresExpr, clang::ConceptSpecializationExpr>(stmt))
      return note(true);
    if (const auto* member = llvm::dyn_cast<clang::CXXDependentScopeMemberExpr>(stmt))
      return note(member->isImplicitAccess() && member->getQualifier() &&
                  !is_of_parameter(member->getQualifier()));
    const auto* made = llvm::dyn_cast<clang::CXXUnresolvedConstructExpr>(stmt);
    const auto* type = made ? made->getTypeAsWritten()->getAs<clang::TemplateSpecializationType>() : nullptr;
    const clang::TemplateDecl* name = type ? type->getTemplateName().getAsTemplateDecl() : nullptr;
    return note(name && (names_trait(name->getName()) || has_statics(name) || is_specialised(name)));
  }
  bool VisitIfStmt(clang::IfStmt* choice) override { return note(choice->isConstexpr()); }
  bool VisitUnaryExprOrTypeTraitExpr(clang::UnaryExprOrTypeTraitExpr*) override { return note(true); }
  bool VisitTypeTraitExpr(clang::TypeTraitExpr*) override { return note(true); }
  bool VisitCXXTypeidExpr(clang::CXXTypeidExpr*) override { return note(true); }
  /// It names the template's arguments.
  bool VisitPredefinedExpr(clang::PredefinedExpr* name) override {
    return note(tells_signature(unit_, name));
  }
  bool VisitDecltypeTypeLoc(clang::DecltypeTypeLoc) override { return note(true); }
  bool VisitVarDecl(clang::VarDecl* variable) override {
    const auto* made = variable->getType()->getAs<clang::TemplateSpecializationType>();
    const clang::TemplateDecl* name = made ? made->getTemplateName().getAsTemplateDecl() : nullptr;
    const bool is_choice = name && made->isDependentType() && (has_statics(name) || is_specialised(name));
    return note(variable->isStaticLocal() || is_choice);
  }
  bool VisitDependentScopeDeclRefExpr(clang::DependentScopeDeclRefExpr* name) override {
    return note(!is_of_parameter(name->getQualifier()));
  }
  bool VisitTemplateSpecializationTypeLoc(clang::TemplateSpecializationTypeLoc named) override {
    const clang::TemplateDecl* name = named.getTypePtr()->getTemplateName().getAsTemplateDecl();
    if (!name || !named.getTypePtr()->isDependentType()) return note(false);
    if (in_parameters_) return note(is_own(name) || has_statics(name) || is_specialised(name));
    if (is_own(name)) look_into(name);
    return !found;
  }
  bool VisitDependentNameTypeLoc(clang::DependentNameTypeLoc name) override {
    const clang::NestedNameSpecifier* qualifier = name.getTypePtr()->getQualifier();
    return note(!is_of_parameter(qualifier) && !is_of_iterator(qualifier));
  }
  bool VisitUnresolvedLookupExpr(clang::UnresolvedLookupExpr* name) override {
    const bool chooses = name->hasExplicitTemplateArgs() || name->getNumDecls() > 1;
    return note(llvm::any_of(name->decls(), [&](const clang::NamedDecl* decl) {
      return llvm::isa<clang::VarTemplateDecl>(decl->getUnderlyingDecl()) || (chooses && is_own(decl)) ||
             (llvm::any_of(name->template_arguments(), is_dependent) && !treats_alike(decl));
    }));
  }
  bool VisitUnresolvedMemberExpr(clang::UnresolvedMemberExpr* name) override {
    return note(name->hasExplicitTemplateArgs() &&
                llvm::any_of(name->decls(), [&](const clang::NamedDecl* decl) { return is_own(decl); }));
  }

 private:
  /// A class template of the package is made with the type: its functions may ask.
  void look_into(const clang::TemplateDecl* name) {
    const auto* record = llvm::dyn_cast_or_null<clang::CXXRecordDecl>(name->getTemplatedDecl());
    clang::CXXRecordDecl* definition = record ? record->getDefinition() : nullptr;
    if (!definition || !seen_.insert(definition).second) return;
    TraverseDecl(definition);
    for (const clang::CXXMethodDecl* method : definition->methods())
      if (const clang::FunctionDecl* defined = method->getDefinition(); defined && defined != method)
        TraverseDecl(const_cast<clang::FunctionDecl*>(defined));
  }
  /// What counts by type (next<M>(), Registry<M>) may keep something for each.
  bool is_own(const clang::NamedDecl* decl) const {
    return unit_.source.in_package(decl->getUnderlyingDecl()->getLocation());
  }
  bool note(bool question) {
    found |= question;
    return !found;
  }
  const Unit& unit_;
  bool in_parameters_ = false;
  std::set<const clang::CXXRecordDecl*> seen_;
};

/// The parameter of the pattern that takes an argument: a pack takes all from its own on.
const clang::ParmVarDecl* parameter_for(const clang::FunctionDecl* pattern, unsigned argument) {
  for (const clang::ParmVarDecl* parameter : pattern->parameters())
    if (parameter->isParameterPack() && parameter->getFunctionScopeIndex() <= argument) return parameter;
  return argument < pattern->getNumParams() ? pattern->getParamDecl(argument) : nullptr;
}

}  // namespace

/// What a library's macro writes is the library's, wherever its headers are found: ROS_INFO names the function that logs.
bool tells_signature(const Unit& unit, const clang::PredefinedExpr* name) {
  const llvm::StringRef kind = name->getIdentKindName();
  if (kind == "__func__" || kind == "__FUNCTION__") return false;
  const clang::SourceManager& manager = unit.ast().getSourceManager();
  const clang::SourceLocation spelled = manager.getSpellingLoc(name->getLocation());
  const bool is_of_library = name->getLocation().isMacroID() && !unit.source.in_package(spelled);
  return !is_of_library && !manager.isInSystemHeader(spelled);
}

bool is_type_blind(const Unit& unit, const clang::FunctionDecl* function, unsigned argument) {
  const clang::FunctionDecl* pattern = function->getTemplateInstantiationPattern();
  if (!pattern && function->getDescribedFunctionTemplate()) pattern = function;
  const clang::ParmVarDecl* parameter = pattern ? parameter_for(pattern, argument) : nullptr;
  if (!parameter || !parameter->getType()->isDependentType()) return true;
  if (!shown_body(pattern)) return false;  // elsewhere, for the types that are instantiated there
  TypeQuestions questions(unit);
  questions.look_at_parameters(pattern->getDescribedFunctionTemplate());
  questions.TraverseDecl(const_cast<clang::FunctionDecl*>(pattern));
  return !questions.found;
}

bool is_type_blind(const Unit& unit, const clang::ClassTemplateSpecializationDecl* instance) {
  const clang::ClassTemplateDecl* pattern = instance->getSpecializedTemplate();
  const clang::CXXRecordDecl* defined = pattern->getTemplatedDecl()->getDefinition();
  if (!defined || instance->isExplicitSpecialization()) return false;
  TypeQuestions questions(unit);
  questions.look_at_class(pattern);
  return !questions.found;
}

}  // namespace tzc::rewriter
