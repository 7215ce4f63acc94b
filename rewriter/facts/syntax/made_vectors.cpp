// SPDX-License-Identifier: BSD-3-Clause
#include "facts/syntax/made_vectors.h"

#include <set>

#include "facts/syntax/ast_walk.h"
#include "facts/syntax/calls.h"
#include "facts/syntax/library_calls.h"
#include "facts/syntax/message_type.h"

namespace tzc::rewriter {
namespace {

const char* const kRule = "assign";

/// std::vector<T>(...), with parentheses; null: something else.
const clang::CXXConstructExpr* made_vector(const clang::Expr* source) {
  source = source->IgnoreImplicit();
  if (const auto* cast = llvm::dyn_cast<clang::CXXFunctionalCastExpr>(source))
    source = cast->getSubExpr()->IgnoreImplicit();
  else if (!llvm::isa<clang::CXXTemporaryObjectExpr>(source))
    return nullptr;
  const auto* made = llvm::dyn_cast<clang::CXXConstructExpr>(source);
  return made && !made->isListInitialization() && !made->isStdInitListInitialization() &&
                 is_data_array(made->getType())
             ? made
             : nullptr;
}

/// A container that holds its elements itself.
bool owns_elements(clang::QualType type) {
  static const std::set<std::string> owners = {"vector", "deque",    "list",          "forward_list", "set",
                                               "array",  "multiset", "unordered_set", "basic_string"};
  if (type->isReferenceType()) return false;
  if (type->isConstantArrayType()) return true;
  const clang::CXXRecordDecl* record = type->getAsCXXRecordDecl();
  return record && record->isInStdNamespace() && owners.count(record->getNameAsString()) != 0;
}

/// A variable, or a member of an object that is no message: an array of a message may be the one that is assigned.
bool is_owner(const clang::Expr* expr) {
  expr = expr->IgnoreParenImpCasts();
  if (const auto* name = llvm::dyn_cast<clang::DeclRefExpr>(expr)) {
    const auto* variable = llvm::dyn_cast<clang::VarDecl>(name->getDecl());
    return variable && owns_elements(variable->getType());
  }
  const auto* member = llvm::dyn_cast<clang::MemberExpr>(expr);
  const auto* field = member ? llvm::dyn_cast<clang::FieldDecl>(member->getMemberDecl()) : nullptr;
  return field && owns_elements(field->getType()) &&
         !message_of(llvm::cast<clang::CXXRecordDecl>(field->getParent()));
}

/// all.begin(), all.rend(), buffer, buffer + n: whose elements they lead to; null: that is not shown.
const clang::Expr* elements_of(const clang::Expr* iterator) {
  static const std::set<std::string> names = {"begin", "end", "cbegin", "cend", "rbegin", "rend"};
  iterator = iterator->IgnoreParens()->IgnoreUnlessSpelledInSource();
  if (const auto* made = llvm::dyn_cast<clang::CXXConstructExpr>(iterator); made && made->getNumArgs() == 1)
    return elements_of(made->getArg(0));
  if (const auto* call = llvm::dyn_cast<clang::CXXMemberCallExpr>(iterator)) {
    const clang::CXXMethodDecl* method = call->getMethodDecl();
    return method && names.count(method->getNameAsString()) != 0 ? call->getImplicitObjectArgument()
                                                                 : nullptr;
  }
  if (const auto* sum = llvm::dyn_cast<clang::BinaryOperator>(iterator);
      sum && sum->getOpcode() == clang::BO_Add)
    return elements_of(sum->getLHS());
  return iterator->IgnoreParenImpCasts()->getType()->isConstantArrayType() ? iterator : nullptr;
}

class MadeVector {
 public:
  MadeVector(const Unit& unit, const clang::CXXOperatorCallExpr* assignment)
      : unit_(unit), assignment_(assignment) {}

  std::vector<Change> changes() const {
    const bool is_assignment =
        assignment_->getOperator() == clang::OO_Equal && assignment_->getNumArgs() == 2;
    const auto* made = is_assignment ? made_vector(assignment_->getArg(1)) : nullptr;
    const clang::Expr* array = made ? assignment_->getArg(0)->IgnoreParenImpCasts() : nullptr;
    if (!array || !is_statement(unit_.ast(), *assignment_) || !is_array_by_name(array)) return {};
    const unsigned arguments = written_arguments(made);
    for (unsigned i = 0; i < arguments; ++i)
      if (!runs_nothing(made->getArg(i))) return {};
    if (arguments == 1 && makes_zeros(made)) return in_place(array, made, ", 0");
    if (arguments == 2 && (fills(made) || copies_others(made))) return in_place(array, made, "");
    return {};
  }

 private:
  /// scan.ranges, this->frame_.data, frame->data: the same array after the arguments.
  static bool is_array_by_name(const clang::Expr* array) {
    const auto* member = llvm::dyn_cast<clang::MemberExpr>(array);
    return member && llvm::isa<clang::FieldDecl>(member->getMemberDecl()) &&
           is_data_array(member->getType()) &&
           message_of(member->getBase()->getType()->isPointerType()
                          ? member->getBase()->getType()->getPointeeType()
                          : member->getBase()->getType()) &&
           is_name(member->getBase());
  }
  static bool is_name(const clang::Expr* expr) {
    expr = expr->IgnoreParenImpCasts();
    if (const auto* member = llvm::dyn_cast<clang::MemberExpr>(expr)) return is_name(member->getBase());
    const auto* op = llvm::dyn_cast<clang::CXXOperatorCallExpr>(expr);
    if (op && (op->getOperator() == clang::OO_Arrow || op->getOperator() == clang::OO_Star))
      return is_name(op->getArg(0));
    return llvm::isa<clang::DeclRefExpr, clang::CXXThisExpr>(expr);
  }

  /// No code of the package, and nothing that changes an object.
  bool runs_nothing(const clang::Stmt* stmt) const {
    if (!stmt) return true;
    if (llvm::isa<clang::LambdaExpr, clang::CXXNewExpr, clang::CXXDeleteExpr, clang::CXXThrowExpr>(stmt))
      return false;
    const auto* op = llvm::dyn_cast<clang::BinaryOperator>(stmt);
    const auto* step = llvm::dyn_cast<clang::UnaryOperator>(stmt);
    if ((op && op->isAssignmentOp()) || (step && step->isIncrementDecrementOp())) return false;
    if (const auto* call = llvm::dyn_cast<clang::CallExpr>(stmt); call && !only_asks(call)) return false;
    const auto* made = llvm::dyn_cast<clang::CXXConstructExpr>(stmt);
    if (made && unit_.source.in_package(made->getConstructor()->getParent()->getLocation())) return false;
    return llvm::all_of(stmt->children(), [&](const clang::Stmt* child) { return runs_nothing(child); });
  }
  bool only_asks(const clang::CallExpr* call) const {
    const clang::FunctionDecl* callee = call->getDirectCallee();
    if (!callee) return false;
    const auto* method = llvm::dyn_cast<clang::CXXMethodDecl>(callee);
    const bool is_question = method && call->getNumArgs() == 0 &&
                             !unit_.source.in_package(method->getParent()->getLocation()) &&
                             (method->isConst() || elements_of(call));
    return is_question || calls_no_package_code(unit_, callee, {call->getArgs(), call->getNumArgs()});
  }

  /// vector(n): of numbers.
  static bool makes_zeros(const clang::CXXConstructExpr* made) {
    return is_counted(made) && element_of(made)->isArithmeticType();
  }
  /// vector(n, value)
  static bool fills(const clang::CXXConstructExpr* made) {
    return is_counted(made) &&
           made->getConstructor()
                   ->getParamDecl(1)
                   ->getType()
                   .getNonReferenceType()
                   .getCanonicalType()
                   .getUnqualifiedType() == element_of(made).getCanonicalType().getUnqualifiedType();
  }
  /// vector(first, last), which may be pointers to anything: Array::assign reads its own elements before they move, and before it
  /// writes there, if they are not smaller than those that it writes.
  bool copies_others(const clang::CXXConstructExpr* made) const {
    if (!made->getConstructor()->getPrimaryTemplate()) return false;
    const clang::Expr* first = elements_of(made->getArg(0));
    const clang::Expr* last = elements_of(made->getArg(1));
    return (first && last && is_owner(first) && is_owner(last)) ||
           (is_large_pointer(made->getArg(0), made) && is_large_pointer(made->getArg(1), made));
  }
  bool is_large_pointer(const clang::Expr* expr, const clang::CXXConstructExpr* made) const {
    const clang::QualType type = expr->IgnoreParenImpCasts()->getType();
    const clang::QualType pointee = type->isPointerType() ? type->getPointeeType() : clang::QualType();
    return !pointee.isNull() && !pointee->isDependentType() && !pointee->isIncompleteType() &&
           unit_.ast().getTypeSize(pointee) >= unit_.ast().getTypeSize(element_of(made));
  }
  static bool is_counted(const clang::CXXConstructExpr* made) {
    return !made->getConstructor()->getPrimaryTemplate() &&
           made->getConstructor()->getParamDecl(0)->getType()->isIntegerType();
  }
  static clang::QualType element_of(const clang::CXXConstructExpr* made) {
    const auto* vector =
        llvm::cast<clang::ClassTemplateSpecializationDecl>(made->getType()->getAsCXXRecordDecl());
    return vector->getTemplateArgs()[0].getAsType();
  }

  std::vector<Change> in_place(const clang::Expr* array, const clang::CXXConstructExpr* made,
                               const char* last) const {
    const auto left = unit_.source.place(array->getSourceRange());
    const auto first = unit_.source.place(made->getArg(0)->getSourceRange());
    const auto behind = unit_.source.place(made->getArg(written_arguments(made) - 1)->getSourceRange());
    const auto whole = unit_.source.place(assignment_->getSourceRange());
    if (!left || !first || !behind || !whole) return {};
    const Place cut{left->file, left->end, first->begin, left->line, left->column};
    std::vector<Change> changes = {{cut, ".assign(", kRule, {}}};
    const Place end{behind->file, behind->end, behind->end, behind->line, behind->column};
    if (*last) changes.push_back({end, last, kRule, {}});
    return changes;
  }

  const Unit& unit_;
  const clang::CXXOperatorCallExpr* assignment_;
};

}  // namespace

std::vector<Change> assignment_in_place(const Unit& unit, const clang::CXXOperatorCallExpr* assignment) {
  return MadeVector(unit, assignment).changes();
}

}  // namespace tzc::rewriter
