// SPDX-License-Identifier: BSD-3-Clause
// A library's function knows code of the package only by the types of its arguments. So a type is asked for all that it is made of:
//
//   a function, a pointer to one or to a member, a closure   it is called
//   a class of the package, by itself                        it may be called
//   a class of a library that can be called                  it calls all that it names: std::_Bind<bool (Node::*(Node*))(uint8_t&)>
//   any other class of a library, a pointer                  it holds, or leads to, what it names: std::vector<Point>, Point*
//   a class of the package that is held so                   the library copies, assigns and compares it, so it gets an element only
//                                                            if one of its constructors or operators takes something by reference
#include "facts/escape/function_objects.h"

#include <clang/AST/DeclFriend.h>
#include <clang/AST/DeclTemplate.h>

#include "facts/escape/escape.h"
#include "facts/syntax/message_type.h"
#include "facts/syntax/package_types.h"

namespace tzc::rewriter {
namespace {

constexpr unsigned max_depth = 8;

const clang::FunctionDecl* function_of(const clang::Decl* decl) {
  const auto* made_friend = llvm::dyn_cast<clang::FriendDecl>(decl);
  if (made_friend) decl = made_friend->getFriendDecl();
  return decl ? decl->getAsFunction() : nullptr;
}

/// What a library calls without being given it: constructors, operators, swap.
bool is_called_by_type(const clang::FunctionDecl* function) {
  return llvm::isa<clang::CXXConstructorDecl>(function) || function->isOverloadedOperator() ||
         (function->getIdentifier() && function->getName() == "swap");
}

bool is_time(const std::string& name) {
  static const std::set<std::string> known = {"ros::Time", "ros::TimeBase", "ros::Duration",
                                              "ros::DurationBase"};
  return known.count(name) != 0;
}

/// std::string, Eigen::Vector3d: no element is of such a class, and one that is made of an element holds no pointer to it.
bool is_no_element(const Unit& unit, const clang::CXXRecordDecl* record) {
  const std::string name = qualified_name_of(record);
  return !unit.source.in_package(record->getLocation()) && !message_of(record) && !is_time(name) &&
         name != "boost::array" && name != "std::array" &&
         !may_hold_pointer(unit.ast().getRecordType(record));
}

class TypeParts {
 public:
  explicit TypeParts(const Unit& unit) : unit_(unit) {}

  /// `called`: what the type names may be called.
  bool may_pass(clang::QualType type, bool called, unsigned depth = 0) const {
    if (type.isNull() || depth > max_depth) return true;
    type = unit_.ast().getBaseElementType(type.getNonReferenceType()).getCanonicalType();
    if (type->isFunctionType() || type->isMemberPointerType()) return true;
    if (type->isPointerType()) return may_pass(type->getPointeeType(), called, depth + 1);
    if (type->isEnumeralType()) return is_taken_beside(type->getAsTagDecl());
    const clang::CXXRecordDecl* record = type->getAsCXXRecordDecl();
    if (!record || message_of(record)) return false;
    if (record->isLambda()) return true;
    if (unit_.source.in_package(record->getLocation())) return called || takes_elements(record, depth);
    return names_taker(record, called || can_be_called(record), depth);
  }

 private:
  /// boost::function1<void, uint8_t&> names no function type.
  bool names_taker(const clang::CXXRecordDecl* record, bool called, unsigned depth) const {
    if (record->getIdentifier() && record->getName().starts_with("function")) return true;
    const auto* made = llvm::dyn_cast<clang::ClassTemplateSpecializationDecl>(record);
    if (made && any_may_pass(made->getTemplateArgs().asArray(), called, depth)) return true;
    const auto* around = llvm::dyn_cast<clang::CXXRecordDecl>(record->getDeclContext());
    return around && names_taker(around, called, depth + 1);
  }
  bool any_may_pass(llvm::ArrayRef<clang::TemplateArgument> arguments, bool called, unsigned depth) const {
    return llvm::any_of(arguments, [&](const clang::TemplateArgument& one) {
      if (one.getKind() == clang::TemplateArgument::Type) return may_pass(one.getAsType(), called, depth + 1);
      if (one.getKind() == clang::TemplateArgument::Pack)
        return any_may_pass(one.pack_elements(), called, depth);
      return one.getKind() == clang::TemplateArgument::Declaration &&
             llvm::isa<clang::FunctionDecl>(one.getAsDecl());
    });
  }

  bool can_be_called(const clang::CXXRecordDecl* record) const {
    if (!record->hasDefinition()) return true;
    const clang::DeclarationName call = unit_.ast().DeclarationNames.getCXXOperatorName(clang::OO_Call);
    return !record->getDefinition()->lookup(call).empty() ||
           llvm::any_of(record->bases(), [&](const clang::CXXBaseSpecifier& base) {
             const clang::CXXRecordDecl* parent = base.getType()->getAsCXXRecordDecl();
             return !parent || can_be_called(parent);
           });
  }

  bool is_taken_beside(const clang::TagDecl* tag) const {
    return llvm::any_of(functions_beside(unit_, tag),
                        [&](const clang::FunctionDecl* function) { return takes_another(function, tag); });
  }
  bool takes_elements(const clang::CXXRecordDecl* record, unsigned depth) const {
    if (!record->hasDefinition()) return true;
    const auto takes = [&](const clang::Decl* decl) {
      const clang::FunctionDecl* function = function_of(decl);
      return function && is_called_by_type(function) && takes_another(function, record);
    };
    return llvm::any_of(record->getDefinition()->decls(), takes) ||
           llvm::any_of(record->getDefinition()->friends(), takes) || is_taken_beside(record) ||
           llvm::any_of(record->bases(), [&](const clang::CXXBaseSpecifier& base) {
             return may_pass(base.getType(), false, depth + 1);
           });
  }
  /// By value a number keeps no pointer to where it was; an object of the class itself is no element.
  bool takes_another(const clang::FunctionDecl* function, const clang::TagDecl* tag) const {
    return llvm::any_of(function->parameters(), [&](const clang::ParmVarDecl* parameter) {
      const clang::QualType type = parameter->getType();
      const clang::CXXRecordDecl* taken = type.getNonReferenceType()->getAsCXXRecordDecl();
      if (!taken) return may_hold_pointer(type);
      return taken->getCanonicalDecl() != tag->getCanonicalDecl() && !is_stream(taken) &&
             !is_no_element(unit_, taken);
    });
  }
  static bool is_stream(const clang::CXXRecordDecl* record) {
    const std::string name = qualified_name_of(record);
    return name == "std::basic_ostream" || name == "std::basic_istream";
  }

  const Unit& unit_;
};

}  // namespace

bool may_pass_elements(const Unit& unit, clang::QualType type) {
  const clang::CXXRecordDecl* record = type.getNonReferenceType()->getAsCXXRecordDecl();
  return TypeParts(unit).may_pass(type, record && unit.source.in_package(record->getLocation()));
}

}  // namespace tzc::rewriter
