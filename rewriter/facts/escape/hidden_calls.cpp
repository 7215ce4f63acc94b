// SPDX-License-Identifier: BSD-3-Clause
#include "facts/escape/hidden_calls.h"

#include <clang/AST/DeclTemplate.h>

#include "facts/syntax/package_types.h"

namespace tzc::rewriter {
namespace {

constexpr unsigned max_depth = 6;

bool keeps_deleter(const clang::CXXRecordDecl* record) {
  static const std::set<std::string> known = {"std::shared_ptr", "boost::shared_ptr", "std::any",
                                              "boost::any", "std::__shared_ptr"};
  return known.count(qualified_name_of(record)) != 0;
}

/// Whether it says nothing of the object that it holds.
bool is_erased(const clang::CXXRecordDecl* record) {
  const auto* made = llvm::dyn_cast<clang::ClassTemplateSpecializationDecl>(record);
  return !made || made->getTemplateArgs().size() == 0 ||
         made->getTemplateArgs()[0].getKind() != clang::TemplateArgument::Type ||
         made->getTemplateArgs()[0].getAsType()->isVoidType();
}

/// Whether what the class is made of says what its objects hold: other classes of libraries keep their own.
bool shows_contents(const clang::CXXRecordDecl* record) {
  const std::string name = qualified_name_of(record);
  return name.rfind("std::", 0) == 0 || name.rfind("boost::", 0) == 0;
}

/// Goes through the classes that make up a type: pointees, template arguments, fields and bases.
template <class Visitor>
class TypeWalk {
 public:
  explicit TypeWalk(Visitor visit) : visit_(std::move(visit)) {}

  void into(clang::QualType type, unsigned depth = 0) {
    if (type.isNull() || depth > max_depth) return;
    type = type.getNonReferenceType().getCanonicalType().getUnqualifiedType();
    if (type->isPointerType()) return into(type->getPointeeType(), depth + 1);
    if (const auto* array = type->getAsArrayTypeUnsafe()) return into(array->getElementType(), depth + 1);
    const clang::CXXRecordDecl* record = type->getAsCXXRecordDecl();
    if (!record || !seen_.insert(record->getCanonicalDecl()).second || !visit_(record)) return;
    if (const auto* made = llvm::dyn_cast<clang::ClassTemplateSpecializationDecl>(record))
      for (const clang::TemplateArgument& argument : made->getTemplateArgs().asArray())
        if (argument.getKind() == clang::TemplateArgument::Type) into(argument.getAsType(), depth + 1);
    if (!record->hasDefinition()) return;
    for (const clang::FieldDecl* field : record->fields()) into(field->getType(), depth + 1);
    for (const clang::CXXBaseSpecifier& base : record->bases()) into(base.getType(), depth);
  }

 private:
  Visitor visit_;
  std::set<const clang::CXXRecordDecl*> seen_;
};

template <class Visitor>
void walk_type(clang::QualType type, Visitor visit) {
  TypeWalk<Visitor>(std::move(visit)).into(type);
}

void add_overridden(const Unit& unit, const clang::CXXMethodDecl* method, std::set<std::string>& classes) {
  for (const clang::CXXMethodDecl* overridden : method->overridden_methods()) {
    if (!unit.source.in_package(overridden->getParent()->getLocation()))
      classes.insert(qualified_name_of(overridden->getParent()));
    add_overridden(unit, overridden, classes);
  }
}

/// [](Image*) {}
bool does_nothing(clang::QualType deleter) {
  const clang::CXXRecordDecl* record = deleter.getNonReferenceType()->getAsCXXRecordDecl();
  const clang::CXXMethodDecl* call = record && record->isLambda() ? record->getLambdaCallOperator() : nullptr;
  const auto* body = call ? llvm::dyn_cast_or_null<clang::CompoundStmt>(call->getBody()) : nullptr;
  return body && body->body_empty();
}

}  // namespace

void HiddenCode::note(clang::QualType object, llvm::ArrayRef<const clang::Expr*> arguments) {
  const clang::CXXRecordDecl* record = object.getNonReferenceType()->getAsCXXRecordDecl();
  if (!record || !keeps_deleter(record) || arguments.empty()) return;
  const bool has_deleter = arguments.size() > 1 && involves_package(unit_, arguments[1]->getType());
  const bool gives = has_deleter ? !does_nothing(arguments[1]->getType())
                                 : involves_package(unit_, arguments[0]->IgnoreParenImpCasts()->getType()) &&
                                       !involves_package(unit_, object);
  if (gives) shown_.insert(a_deleter);
}

void HiddenCode::note(const clang::CXXRecordDecl* record) {
  for (const clang::CXXMethodDecl* method : record->methods())
    if (method->isUserProvided() ||
        (llvm::isa<clang::CXXDestructorDecl>(method) && parts_involve_package(unit_, record)))
      add_overridden(unit_, method, shown_);
}

/// What another unit has put into shared_ptr<void> or any, this one does not show.
const HiddenCode::Parts& HiddenCode::parts_of(clang::QualType type) {
  const clang::QualType plain = type.getNonReferenceType().getCanonicalType().getUnqualifiedType();
  const auto [known, is_new] = parts_.emplace(plain.getTypePtrOrNull(), Parts());
  Parts& parts = known->second;
  if (!is_new) return parts;
  walk_type(plain, [&](const clang::CXXRecordDecl* record) {
    if (keeps_deleter(record))
      parts.at_end = either(parts.at_end, is_erased(record) ? IfShown() : if_deleter_);
    return shows_contents(record) || unit_.source.in_package(record->getLocation());
  });
  IfShown::Names polymorphic;
  walk_type(plain, [&](const clang::CXXRecordDecl* record) {
    if (unit_.source.in_package(record->getLocation())) return false;
    if (!record->hasDefinition() || record->isPolymorphic()) polymorphic.insert(qualified_name_of(record));
    return true;
  });
  if (!polymorphic.empty()) parts.in_library = IfShown(std::move(polymorphic));
  return parts;
}

bool may_call_back(clang::QualType type) {
  static const std::set<std::string> keepers = {"std::function", "boost::function", "boost::signals2::signal",
                                                "boost::signal"};
  bool found = false;
  walk_type(type, [&](const clang::CXXRecordDecl* record) {
    const std::string name = qualified_name_of(record);
    found = found || keepers.count(name) != 0;
    return !found && name.rfind("ros::", 0) != 0;
  });
  return found;
}

}  // namespace tzc::rewriter
