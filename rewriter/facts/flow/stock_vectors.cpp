// SPDX-License-Identifier: BSD-3-Clause
#include "facts/flow/stock_vectors.h"

#include <clang/AST/TypeLoc.h>

#include <set>
#include <string>

#include "facts/syntax/ast_walk.h"
#include "facts/syntax/made_vectors.h"
#include "facts/syntax/message_type.h"

namespace tzc::rewriter {
namespace {

const char* const kRule = "stock-vector";

/// The type of a variable as it is written, or that of what it refers or points to; none: it is deduced, or a name stands for the
/// reference or the pointer.
clang::TypeLoc written_type(const clang::VarDecl* variable) {
  const clang::TypeSourceInfo* info = variable->getTypeSourceInfo();
  if (!info || variable->isImplicit() || info->getType()->getContainedDeducedType()) return {};
  const clang::TypeLoc type = info->getTypeLoc().getUnqualifiedLoc();
  if (const auto reference = type.getAs<clang::ReferenceTypeLoc>())
    return reference.getPointeeLoc().getUnqualifiedLoc();
  if (const auto pointer = type.getAs<clang::PointerTypeLoc>())
    return pointer.getPointeeLoc().getUnqualifiedLoc();
  return type;
}

/// last_, this->state.last, frame->last
bool is_name(const clang::Expr* expr) {
  expr = expr->IgnoreParenImpCasts();
  const auto* member = llvm::dyn_cast<clang::MemberExpr>(expr);
  return member ? is_name(member->getBase()) : llvm::isa<clang::DeclRefExpr, clang::CXXThisExpr>(expr);
}

class VectorUse {
 public:
  VectorUse(const Unit& unit, const clang::MemberExpr* array) : unit_(unit), array_(array) {}

  std::vector<Change> changes() const {
    auto around = around_of(clang::DynTypedNode::create(*array_));
    const auto* address = around ? around->get<clang::UnaryOperator>() : nullptr;
    if (address && address->getOpcode() == clang::UO_AddrOf) around = around_of(*around);
    if (!around || !place_of(array_)) return {};
    if (const auto* variable = around->get<clang::VarDecl>()) return of_name(variable);
    if (const auto* member = around->get<clang::MemberExpr>()) return of_iterator(member);
    if (const auto* op = around->get<clang::CXXOperatorCallExpr>()) return of_assignment(op);
    const auto* copy = around->get<clang::CXXConstructExpr>();
    return copy && copy->getConstructor()->isCopyConstructor() ? of_copy(copy) : std::vector<Change>();
  }

 private:
  /// Without what nobody wrote.
  std::optional<clang::DynTypedNode> around_of(clang::DynTypedNode node) const {
    for (;;) {
      const auto around = written_parent(unit_.ast(), node);
      if (!around || !is_wrapping(around->get<clang::Stmt>())) return around;
      node = *around;
    }
  }

  std::optional<Place> place_of(const clang::Stmt* stmt) const {
    return unit_.source.place(stmt->getSourceRange());
  }
  Change in_front(std::string text) const {
    const Place at = *place_of(array_);
    return {{at.file, at.begin, at.begin, at.line, at.column}, std::move(text), kRule, {}};
  }
  Change behind(std::string text) const {
    const Place at = *place_of(array_);
    return {{at.file, at.end, at.end, at.line, at.column}, std::move(text), kRule, {}};
  }

  std::vector<Change> of_name(const clang::VarDecl* variable) const {
    const auto* declaration = parent_as<clang::DeclStmt>(unit_.ast(), *variable);
    if (!variable->isLocalVarDecl() || variable->getType()->isRecordType() || !declaration ||
        !declaration->isSingleDecl())
      return {};
    const clang::TypeLoc written = written_type(variable);
    const auto where = written ? unit_.source.place(written.getSourceRange()) : std::optional<Place>();
    return where ? std::vector<Change>{{*where, "auto", kRule, {}}} : std::vector<Change>();
  }

  /// std::vector<float>::iterator range = scan.ranges.begin(), end = scan.ranges.end();
  std::vector<Change> of_iterator(const clang::MemberExpr* member) const {
    const auto* call = parent_as<clang::CXXMemberCallExpr>(unit_.ast(), *member);
    const clang::VarDecl* variable = call && is_iterator(call) ? initialized_by(call) : nullptr;
    const auto* declaration = variable ? parent_as<clang::DeclStmt>(unit_.ast(), *variable) : nullptr;
    if (!declaration || *declaration->decl_begin() != variable) return {};
    const bool are_all_deduced = llvm::all_of(declaration->decls(), [&](const clang::Decl* one) {
      const auto* other = llvm::dyn_cast<clang::VarDecl>(one);
      const clang::Expr* value = other ? other->getInit() : nullptr;
      const auto* source = value ? llvm::dyn_cast<clang::CXXMemberCallExpr>(without_copies(value)) : nullptr;
      // Deduced, an iterator of a message that is not const lets write where it did not.
      return source && is_iterator(source) &&
             unit_.ast().hasSameUnqualifiedType(source->getType(), variable->getType());
    });
    const clang::TypeLoc written = written_type(variable);
    const auto where =
        are_all_deduced && written ? unit_.source.place(written.getSourceRange()) : std::optional<Place>();
    return where ? std::vector<Change>{{*where, "auto", kRule, {}}} : std::vector<Change>();
  }

  static bool is_iterator(const clang::CXXMemberCallExpr* call) {
    static const std::set<std::string> names = {"begin",  "end",  "rbegin",  "rend",
                                                "cbegin", "cend", "crbegin", "crend"};
    return call->getMethodDecl() && names.count(call->getMethodDecl()->getNameAsString()) != 0;
  }

  /// Before C++17 a value is copied into its variable.
  static const clang::Expr* without_copies(const clang::Expr* value) {
    for (;;) {
      value = value->IgnoreImplicit();
      const auto* copy = llvm::dyn_cast<clang::CXXConstructExpr>(value);
      if (!copy || !copy->isElidable() || copy->getNumArgs() == 0) return value;
      value = copy->getArg(0);
    }
  }

  /// A local variable whose initial value a call is; null: it is none's.
  const clang::VarDecl* initialized_by(const clang::CXXMemberCallExpr* call) const {
    for (const clang::DynTypedNode& node : ancestors(unit_.ast(), *call)) {
      const auto* variable = node.get<clang::VarDecl>();
      if (variable && variable->getInit() && variable->isLocalVarDecl() &&
          without_copies(variable->getInit()) == call)
        return variable;
      if (!node.get<clang::Expr>()) return nullptr;
    }
    return nullptr;
  }

  std::vector<Change> of_copy(const clang::CXXConstructExpr* copy) const {
    if (!is_data_array(copy->getType())) return {};
    const auto around = around_of(clang::DynTypedNode::create(*copy));
    if (!around) return {};
    clang::SourceRange type;
    if (const auto* variable = around->get<clang::VarDecl>()) {
      const clang::TypeLoc written = written_type(variable);
      if (written && variable->getInitStyle() == clang::VarDecl::CInit) type = written.getSourceRange();
    } else if (const auto* returned = around->get<clang::ReturnStmt>()) {
      type = result_type(returned);
    }
    const auto where = type.isValid() ? unit_.source.place(type) : std::optional<Place>();
    if (!where) return {};
    return {in_front(unit_.source.text(*where) + "("), behind(")")};
  }

  clang::SourceRange result_type(const clang::ReturnStmt* returned) const {
    const clang::FunctionDecl* function = enclosing_function(unit_.ast(), *returned);
    if (!function || is_lambda(function) || function->getDeclaredReturnType()->getContainedDeducedType())
      return {};
    return function->getReturnTypeSourceRange();
  }

  std::vector<Change> of_assignment(const clang::CXXOperatorCallExpr* op) const {
    if (op->getArg(0)->IgnoreParenImpCasts() == array_) return assignment_in_place(unit_, op);
    if (op->getOperator() != clang::OO_Equal || op->getArg(1)->IgnoreImpCasts() != array_) return {};
    const clang::Expr* target = op->getArg(0)->IgnoreImpCasts();
    const auto whole = place_of(op), left = place_of(target);
    if (!is_statement(unit_.ast(), *op) || !whole || !left || !is_other_vector(target)) return {};
    const Place cut{whole->file, whole->begin, place_of(array_)->begin, whole->line, whole->column};
    return {{cut, "", kRule, {}}, behind(".copy_to(" + unit_.source.text(*left) + ")")};
  }

  /// A vector by its own name, and no array of a message.
  bool is_other_vector(const clang::Expr* target) const {
    if (!is_data_array(target->getType()) || !is_name(target)) return false;
    if (const auto* name = llvm::dyn_cast<clang::DeclRefExpr>(target)) {
      const auto* variable = llvm::dyn_cast<clang::VarDecl>(name->getDecl());
      return variable && !variable->getType()->isReferenceType() && bool(written_type(variable));
    }
    const auto* member = llvm::dyn_cast<clang::MemberExpr>(target);
    const auto* field = member ? llvm::dyn_cast<clang::FieldDecl>(member->getMemberDecl()) : nullptr;
    return field && !field->getType()->isReferenceType() &&
           !message_of(llvm::cast<clang::CXXRecordDecl>(field->getParent()));
  }

  const Unit& unit_;
  const clang::MemberExpr* array_;
};

}  // namespace

std::vector<Change> changes_for_stock_vector(const Unit& unit, const clang::MemberExpr* array) {
  return VectorUse(unit, array).changes();
}

}  // namespace tzc::rewriter
