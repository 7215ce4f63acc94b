// SPDX-License-Identifier: BSD-3-Clause
// A library's function knows code of the package only by the types of its arguments. So a type is asked for all that it is made of:
//
//   a function, a pointer to one or to a member, a closure   it is called
//   a class of the package, by itself                        it may be called
//   a class of a library that can be called                  it calls all that it names: std::_Bind<bool (Node::*(Node*))(uint8_t&)>
//   any other class of a library, a pointer                  it holds, or leads to, what it names: std::vector<Point>, Point*
//   a class of the package that is held so                   the library copies, assigns and compares it, so it gets an element only
//                                                            if one of its constructors or operators takes by reference what an
//                                                            element may be, or become by a constructor of the package
#include "facts/escape/function_objects.h"

#include <clang/AST/DeclFriend.h>
#include <clang/AST/DeclTemplate.h>

#include <set>

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
  TypeParts(const Unit& unit, clang::QualType element) : unit_(unit), element_(element) {}
  const std::string& taker() const { return taker_; }

  /// `called`: what the type names may be called.
  bool may_pass(clang::QualType type, bool called, unsigned depth = 0) {
    if (type.isNull() || depth > max_depth) return true;
    type = unit_.ast().getBaseElementType(type.getNonReferenceType()).getCanonicalType();
    if (type->isFunctionType() || type->isMemberPointerType()) return true;
    if (type->isPointerType()) return may_pass(type->getPointeeType(), called, depth + 1);
    if (type->isEnumeralType()) return is_taken_beside(type->getAsTagDecl(), depth);
    const clang::CXXRecordDecl* record = type->getAsCXXRecordDecl();
    if (!record || message_of(record)) return false;
    if (record->isLambda()) return true;
    if (unit_.source.in_package(record->getLocation())) return called || takes_elements(record, depth);
    return names_taker(record, called || can_be_called(record), depth);
  }

 private:
  /// boost::function1<void, uint8_t&> names no function type.
  bool names_taker(const clang::CXXRecordDecl* record, bool called, unsigned depth) {
    if (record->getIdentifier() && record->getName().starts_with("function")) return true;
    const auto* made = llvm::dyn_cast<clang::ClassTemplateSpecializationDecl>(record);
    if (made && any_may_pass(made->getTemplateArgs().asArray(), called, depth)) return true;
    const auto* around = llvm::dyn_cast<clang::CXXRecordDecl>(record->getDeclContext());
    return around && names_taker(around, called, depth + 1);
  }
  bool any_may_pass(llvm::ArrayRef<clang::TemplateArgument> arguments, bool called, unsigned depth) {
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

  bool is_taken_beside(const clang::TagDecl* tag, unsigned depth) {
    return llvm::any_of(functions_beside(unit_, tag), [&](const clang::FunctionDecl* function) {
      return takes_another(function, tag, depth);
    });
  }
  bool takes_elements(const clang::CXXRecordDecl* record, unsigned depth) {
    if (!record->hasDefinition()) return true;
    if (!asked_.insert(record->getCanonicalDecl()).second)
      return false;  // the answer is that of the first time
    const auto takes = [&](const clang::Decl* decl) {
      const clang::FunctionDecl* function = function_of(decl);
      return function && is_called_by_type(function) && takes_another(function, record, depth);
    };
    return llvm::any_of(record->getDefinition()->decls(), takes) ||
           llvm::any_of(record->getDefinition()->friends(), takes) || is_taken_beside(record, depth) ||
           llvm::any_of(record->bases(), [&](const clang::CXXBaseSpecifier& base) {
             return may_pass(base.getType(), false, depth + 1);
           });
  }
  /// By value a number keeps no pointer to where it was; an object of the class itself is no element.
  bool takes_another(const clang::FunctionDecl* function, const clang::TagDecl* tag, unsigned depth) {
    const bool takes = llvm::any_of(function->parameters(), [&](const clang::ParmVarDecl* parameter) {
      const clang::QualType type = parameter->getType();
      const clang::CXXRecordDecl* taken = type.getNonReferenceType()->getAsCXXRecordDecl();
      if (!taken) return may_hold_pointer(type) && may_refer_to_element(type);
      return taken->getCanonicalDecl() != tag->getCanonicalDecl() && !is_stream(taken) &&
             !is_no_element(unit_, taken) && may_be_made_of_element(taken, depth);
    });
    if (takes && taker_.empty()) taker_ = "'" + tag->getNameAsString() + "'";
    return takes;
  }
  /// A reference to a number of another type means a new number, and a pointer to an element becomes none to another type.
  bool may_refer_to_element(clang::QualType type) const {
    type = type.getNonReferenceType();
    return may_be_element(type->isPointerType() ? type->getPointeeType() : type);
  }
  bool may_be_element(clang::QualType type) const {
    if (element_.isNull() || type->isDependentType() || type->isVoidType()) return true;
    if (unit_.ast().hasSameUnqualifiedType(type, element_)) return true;
    const clang::CXXRecordDecl *base = type->getAsCXXRecordDecl(), *element = element_->getAsCXXRecordDecl();
    return base && element && (!element->hasDefinition() || element->isDerivedFrom(base));
  }
  /// Of a library's class that may hold a pointer, what it is made of is not asked: it may be an iterator. No smart pointer is made
  /// of a plain one, nor of a number, without being named.
  bool may_be_made_of_element(const clang::CXXRecordDecl* record, unsigned depth) {
    const clang::QualType type = unit_.ast().getRecordType(record);
    if (may_be_element(type)) return true;
    if (unit_.source.in_package(record->getLocation())) return takes_elements(record, depth + 1);
    return !message_of(record) && pointee_of(type).isNull() && may_hold_pointer(type);
  }
  static bool is_stream(const clang::CXXRecordDecl* record) {
    const std::string name = qualified_name_of(record);
    return name == "std::basic_ostream" || name == "std::basic_istream";
  }

  const Unit& unit_;
  const clang::QualType element_;
  std::set<const clang::CXXRecordDecl*> asked_;
  std::string taker_;  ///< the class or enumeration whose function takes elements
};

}  // namespace

std::string passes_elements_to(const Unit& unit, clang::QualType type, clang::QualType element) {
  const clang::CXXRecordDecl* record = type.getNonReferenceType()->getAsCXXRecordDecl();
  TypeParts parts(unit, element);
  if (!parts.may_pass(type, record && unit.source.in_package(record->getLocation()))) return "";
  return parts.taker().empty() ? "a function object" : parts.taker();
}

}  // namespace tzc::rewriter
