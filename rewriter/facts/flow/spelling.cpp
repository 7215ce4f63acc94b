// SPDX-License-Identifier: BSD-3-Clause
// How a type is written, and how it is written once ported.
#include "facts/flow/spelling.h"

#include "facts/syntax/message_type.h"
#include "model/codes.h"

namespace tzc::rewriter {
namespace {

struct Spelling {
  std::string text, rule;
  std::vector<std::string> headers;
};

/// Of a publisher's or filter's class. Clouds are read from shared memory where TZC's header for them is included.
Spelling spelling_of(const ClassRename& rename, clang::QualType type) {
  Spelling spelling{rename.to, rename.rule, {rename.header}};
  if (is_pcl_cloud(first_argument(type))) spelling.headers.push_back("tzc/pcl.h");
  return spelling;
}

std::string pointer_name(const std::string& twin, clang::QualType type) {
  const clang::QualType pointee = pointee_of(type);
  const auto* record = type.getCanonicalType()->getAsCXXRecordDecl();
  if (record && record->getName() == "shared_ptr" && !record->isInStdNamespace())
    return twin + (pointee.isConstQualified() ? "ConstPtr" : "Ptr");
  const std::string name = record ? qualified_name_of(record) : "";
  if (name.empty()) return "";
  return name + "<" + twin + (pointee.isConstQualified() ? " const>" : ">");
}

/// The class that a type of something of this role is renamed to; null: none.
const ClassRename* rename_of(const Unit& unit, clang::QualType type, EntityRole role) {
  const clang::CXXRecordDecl* record = type.getCanonicalType()->getAsCXXRecordDecl();
  const ClassRename* rename = record ? unit.rules.find_class(qualified_name_of(record)) : nullptr;
  return rename && role_of(*rename) == role ? rename : nullptr;
}

/// The ported name of a type that is written as one name; empty when there is none.
std::optional<Spelling> ported_name(const Unit& unit, clang::QualType type, EntityRole role) {
  if (const ClassRename* rename = rename_of(unit, type, role)) return spelling_of(*rename, type);
  if (role != EntityRole::message) return {};
  if (const auto message = message_of(type); message && !type->isReferenceType())
    return Spelling{twin_name(message->name), "message-type", {twin_header(message->name)}};
  const clang::QualType pointee = pointee_of(type);
  if (pointee.isNull() || type->isPointerType()) return {};
  const auto message = message_of(pointee);
  if (!message) return {};
  return Spelling{pointer_name(twin_name(message->name), type), "message-type", {twin_header(message->name)}};
}

/// The edit that writes `spelling` over `old_text`: where only the namespace differs, an insertion.
Change change_of(Place where, const Spelling& spelling, const std::string& old_text) {
  Change change{std::move(where), spelling.text, spelling.rule, spelling.headers};
  const std::string prefix = "tzc::";
  const std::string package = spelling.text.rfind(prefix, 0) == 0
                                  ? spelling.text.substr(5, spelling.text.find("::", 5) - 5) + "::"
                                  : "";
  const bool same_name = spelling.text == prefix + old_text;
  const bool same_package =
      spelling.rule == "message-type" && !package.empty() && old_text.rfind(package, 0) == 0;
  if (same_name || same_package) {
    change.where.end = change.where.begin;
    change.text = prefix;
  } else if (!package.empty() && old_text.rfind("::" + package, 0) == 0) {
    change.where.end = change.where.begin;
    change.text = "::tzc";
  }
  return change;
}

/// A typedef of a filter class hides the message, which the ported class has to be given.
std::string hidden_arguments(clang::QualType type, const clang::PrintingPolicy& policy) {
  if (message_of(type) || !pointee_of(type).isNull()) return "";
  const clang::QualType argument = first_argument(type);
  if (is_pcl_cloud(argument)) return "<" + argument.getCanonicalType().getAsString(policy) + ">";
  const auto message = message_of(argument);
  return message ? "<" + stock_name(message->name) + ">" : "";
}

/// typedef message_filters::Subscriber<M> Sub; of a class template, where the type is written once for all its instances.
bool is_name_of_instance(clang::TypeLoc type) {
  const auto name = type.getAs<clang::TypedefTypeLoc>();
  for (const clang::DeclContext* context = name ? name.getTypedefNameDecl()->getDeclContext() : nullptr;
       context; context = context->getParent())
    if (llvm::isa<clang::ClassTemplateSpecializationDecl>(context)) return true;
  return false;
}

/// Whether an expression names something of the package that may be ported: then its type changes with that.
bool names_entity(const Unit& unit, const clang::Stmt* expr) {
  const clang::ValueDecl* decl = nullptr;
  if (const auto* name = llvm::dyn_cast<clang::DeclRefExpr>(expr)) decl = name->getDecl();
  if (const auto* member = llvm::dyn_cast<clang::MemberExpr>(expr)) decl = member->getMemberDecl();
  if (decl && unit.source.in_package(decl->getLocation()) && carried_by(decl->getType(), unit.rules))
    return true;
  return llvm::any_of(expr->children(),
                      [&](const clang::Stmt* child) { return child && names_entity(unit, child); });
}

class Speller {
 public:
  Speller(const Unit& unit, EntityRole role) : unit_(unit), role_(role) {}

  void respell(clang::TypeLoc type);
  Respelling result() && { return std::move(result_); }

 private:
  void change_name(clang::SourceRange tokens, const Spelling& spelling);
  void respell_template(clang::TemplateSpecializationTypeLoc type, clang::SourceLocation begin);
  void respell_name(clang::TypeLoc type, clang::SourceRange tokens, clang::NestedNameSpecifierLoc qualifier);
  bool respell_qualifier(clang::NestedNameSpecifierLoc qualifier);
  void respell_decltype(clang::DecltypeTypeLoc type);
  void obstruct(const char* code, const std::string& reason, clang::SourceLocation where) {
    result_.obstacles.push_back({code, reason, unit_.location(where)});
  }

  const Unit& unit_;
  const EntityRole role_;
  Respelling result_;
};

void Speller::change_name(clang::SourceRange tokens, const Spelling& spelling) {
  if (const std::optional<Place> where = unit_.source.place(tokens))
    result_.changes.push_back(change_of(*where, spelling, unit_.source.text(*where)));
  else
    obstruct(codes::TZC1006, "its type is written by a macro", tokens.getBegin());
}

void Speller::respell_template(clang::TemplateSpecializationTypeLoc type, clang::SourceLocation begin) {
  if (const ClassRename* rename = rename_of(unit_, type.getType(), role_))
    return change_name({begin, type.getTemplateNameLoc()}, spelling_of(*rename, type.getType()));
  for (unsigned i = 0; i < type.getNumArgs(); ++i)
    if (clang::TypeSourceInfo* argument = type.getArgLoc(i).getTypeSourceInfo())
      respell(argument->getTypeLoc());
}

void Speller::respell_name(clang::TypeLoc type, clang::SourceRange tokens,
                           clang::NestedNameSpecifierLoc qualifier) {
  if (const auto parameter = type.getAs<clang::SubstTemplateTypeParmTypeLoc>()) {
    // What a function template is called with decides; the arguments of a class template are written somewhere else.
    if (!llvm::isa<clang::FunctionDecl, clang::FunctionTemplateDecl>(
            parameter.getTypePtr()->getAssociatedDecl()))
      obstruct(codes::TZC1005,
               "its type is the parameter '" + unit_.source.text(tokens) + "' of a class template",
               tokens.getBegin());
    return;
  }
  if (type.getAs<clang::TemplateTypeParmTypeLoc>()) return;
  if (auto spelling = ported_name(unit_, type.getType(), role_); spelling && !spelling->text.empty()) {
    const std::string arguments = hidden_arguments(type.getType(), unit_.ast().getPrintingPolicy());
    if (!arguments.empty() && is_name_of_instance(type))
      return obstruct(
          codes::TZC1007,
          "the name '" + unit_.source.text(tokens) + "' means another type in each instance of a template",
          tokens.getBegin());
    spelling->text += arguments;
    return change_name(tokens, *spelling);
  }
  const auto carried = carried_by(type.getType(), unit_.rules);
  if (carried && carried->role == role_ && !respell_qualifier(qualifier))
    obstruct(codes::TZC1005, "its type hides behind the name '" + unit_.source.text(tokens) + "'",
             tokens.getBegin());
}

/// std::vector<Marker>::iterator, MarkerArray::_markers_type::iterator: a member of a type whose name is ported; the twin has it,
/// too. False: there is no such name in front of it.
bool Speller::respell_qualifier(clang::NestedNameSpecifierLoc qualifier) {
  for (; qualifier; qualifier = qualifier.getPrefix()) {
    const clang::TypeLoc type = qualifier.getTypeLoc();
    if (type.isNull()) continue;
    const auto message = message_of(type.getType());
    if (message && role_ == EntityRole::message) {
      if (!unit_.has_twin(message->name)) return false;
      change_name({qualifier.getBeginLoc(), type.getEndLoc()},
                  {twin_name(message->name), "message-type", {twin_header(message->name)}});
      return true;
    }
    const auto made = type.getAs<clang::TemplateSpecializationTypeLoc>();
    if (!made || !carried_by(type.getType(), unit_.rules)) continue;
    respell_template(made, qualifier.getBeginLoc());
    return true;
  }
  return false;
}

void Speller::respell_decltype(clang::DecltypeTypeLoc type) {
  const clang::Expr* operand = type.getUnderlyingExpr();
  const auto carried = carried_by(type.getType(), unit_.rules);
  if (carried && carried->role == role_ && !names_entity(unit_, operand))
    obstruct(codes::TZC1005,
             "its type hides behind the name '" + unit_.source.text(type.getSourceRange()) + "'",
             type.getBeginLoc());
}

void Speller::respell(clang::TypeLoc type) {
  const clang::SourceRange tokens = type.getSourceRange();
  if (type.isNull() || tokens.isInvalid()) return;
  if (const auto qualified = type.getAs<clang::QualifiedTypeLoc>())
    return respell(qualified.getUnqualifiedLoc());
  if (const auto pointer = type.getAs<clang::PointerTypeLoc>()) return respell(pointer.getPointeeLoc());
  if (const auto reference = type.getAs<clang::ReferenceTypeLoc>()) return respell(reference.getPointeeLoc());
  if (const auto array = type.getAs<clang::ArrayTypeLoc>()) return respell(array.getElementLoc());
  if (const auto parens = type.getAs<clang::ParenTypeLoc>()) return respell(parens.getInnerLoc());
  if (type.getAs<clang::AutoTypeLoc>()) return;
  if (const auto asked = type.getAs<clang::DecltypeTypeLoc>()) return respell_decltype(asked);
  const auto elaborated = type.getAs<clang::ElaboratedTypeLoc>();
  const clang::TypeLoc named = elaborated ? elaborated.getNamedTypeLoc() : type;
  if (const auto templated = named.getAs<clang::TemplateSpecializationTypeLoc>())
    return respell_template(templated, tokens.getBegin());
  respell_name(named, tokens, elaborated ? elaborated.getQualifierLoc() : clang::NestedNameSpecifierLoc());
}

}  // namespace

Respelling respell(const Unit& unit, clang::TypeLoc written, EntityRole role) {
  Speller speller(unit, role);
  speller.respell(written);
  return std::move(speller).result();
}

}  // namespace tzc::rewriter
