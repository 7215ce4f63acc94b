// SPDX-License-Identifier: BSD-3-Clause
#include "facts/member_mentions.h"

#include <algorithm>

#include "facts/ast_walk.h"
#include "facts/calls.h"
#include "facts/escape_climb.h"
#include "parse/ast_visitor.h"

namespace tzc::rewriter {
namespace {

bool may_have_array(clang::QualType type) {
  if (type->isArithmeticType() || type->isEnumeralType()) return false;
  const clang::CXXRecordDecl* record = type->getAsCXXRecordDecl();
  if (!record || !record->hasDefinition() || is_data_array(type)) return true;
  if (qualified_name_of(record) == "std::basic_string") return false;
  return llvm::any_of(record->fields(),
                      [](const clang::FieldDecl* part) { return may_have_array(part->getType()); }) ||
         llvm::any_of(record->bases(),
                      [](const clang::CXXBaseSpecifier& base) { return may_have_array(base.getType()); });
}

/// image_.width, image_.header: no array of the message is touched.
bool names_a_part_without_arrays(clang::ASTContext& ast, const clang::Expr* mention) {
  const auto* part = parent_as<clang::MemberExpr>(ast, *mention);
  return part && llvm::isa<clang::FieldDecl>(part->getMemberDecl()) && !may_have_array(part->getType());
}

/// frame->image, (*frame).image, frames[i].image, frame.get()->image: what the step starts from.
const clang::Expr* step_back(const clang::Expr* expr) {
  if (const auto* member = llvm::dyn_cast<clang::MemberExpr>(expr)) return member->getBase();
  if (const auto* op = llvm::dyn_cast<clang::CXXOperatorCallExpr>(expr)) return op->getArg(0);
  if (const auto* op = llvm::dyn_cast<clang::UnaryOperator>(expr)) return op->getSubExpr();
  if (const auto* subscript = llvm::dyn_cast<clang::ArraySubscriptExpr>(expr)) return subscript->getBase();
  const auto* call = llvm::dyn_cast<clang::CXXMemberCallExpr>(expr);
  return call ? call->getImplicitObjectArgument() : nullptr;
}

/// The variable or own member at which an expression begins; null: neither.
const clang::ValueDecl* begin_of(const clang::Expr* expr) {
  for (; expr; expr = step_back(expr)) {
    expr = expr->IgnoreParenImpCasts();
    if (const auto* reference = llvm::dyn_cast<clang::DeclRefExpr>(expr)) return reference->getDecl();
    const auto* member = llvm::dyn_cast<clang::MemberExpr>(expr);
    if (member && llvm::isa<clang::CXXThisExpr>(member->getBase()->IgnoreParenImpCasts()))
      return member->getMemberDecl();
  }
  return nullptr;
}

/// What a member message is part of; null: of this object, or a global.
const clang::ValueDecl* object_of(const clang::Expr* mention) {
  const auto* member = llvm::dyn_cast<clang::MemberExpr>(mention->IgnoreParenImpCasts());
  const clang::Expr* base = member ? member->getBase()->IgnoreParenImpCasts() : nullptr;
  return base && !llvm::isa<clang::CXXThisExpr>(base) ? begin_of(base) : nullptr;
}

/// Whether a variable gets what may point into what is mentioned.
bool leaves_pointer(const Unit& unit, const clang::Expr* mention) {
  for (const clang::DynTypedNode& node : ancestors(unit.ast(), *mention)) {
    if (const auto* variable = node.get<clang::VarDecl>())
      return variable->getType()->isReferenceType() || may_hold_pointer(variable->getType());
    const auto* op = node.get<clang::BinaryOperator>();
    const auto* call = node.get<clang::CXXOperatorCallExpr>();
    if (op && op->isAssignmentOp()) return may_hold_pointer(op->getLHS()->getType());
    if (call && call->isAssignmentOp()) return may_hold_pointer(call->getArg(0)->getType());
    if (!node.get<clang::Expr>()) return false;
  }
  return false;
}

/// left.image, frame_.image, image_: no pointer, reference or index leads there.
bool is_by_value(const clang::Expr* mention) {
  mention = mention->IgnoreParenImpCasts();
  if (const auto* reference = llvm::dyn_cast<clang::DeclRefExpr>(mention))
    return !reference->getDecl()->getType()->isReferenceType();
  const auto* member = llvm::dyn_cast<clang::MemberExpr>(mention);
  if (!member || member->getType()->isReferenceType()) return false;
  if (llvm::isa<clang::CXXThisExpr>(member->getBase()->IgnoreParenImpCasts())) return true;
  return !member->isArrow() && is_by_value(member->getBase());
}

bool is_accessor(const clang::CXXMethodDecl* method) {
  return method->getOverloadedOperator() != clang::OO_None ||
         (method->getIdentifier() && method->getName() == "get");
}

/// Whether a function gets the object that a mention names, or a pointer or reference to it.
class HandsOn {
 public:
  HandsOn(const Unit& unit, const std::string& way) : unit_(unit), way_(way) {}

  bool operator()(const clang::Expr* mention) const {
    for (const clang::Expr* expr = mention; expr;) {
      const auto* around = parent_as<clang::Expr>(unit_.ast(), *expr);
      if (!around) return false;
      if (const std::optional<bool> answer = at(expr, around)) return *answer;
      expr = around;
    }
    return false;
  }

 private:
  /// None: the step leads to the object still.
  std::optional<bool> at(const clang::Expr* expr, const clang::Expr* around) const {
    if (const auto* member = llvm::dyn_cast<clang::MemberExpr>(around)) return at_member(member);
    if (llvm::isa<clang::CXXConstructExpr>(around)) return true;
    const auto* op = llvm::dyn_cast<clang::CXXOperatorCallExpr>(around);
    if (op && op->getArg(0) == expr && llvm::isa_and_nonnull<clang::CXXMethodDecl>(op->getDirectCallee()))
      return op->isAssignmentOp() ? std::optional(true) : std::nullopt;  // *frame, frame->, frames[i]
    if (const auto* call = llvm::dyn_cast<clang::CallExpr>(around))
      return call->getCallee() == expr ? std::nullopt : std::optional(true);
    if (llvm::isa<clang::ParenExpr, clang::CastExpr, clang::UnaryOperator, clang::ArraySubscriptExpr>(around))
      return {};
    return false;
  }
  std::optional<bool> at_member(const clang::MemberExpr* member) const {
    const auto* method = llvm::dyn_cast<clang::CXXMethodDecl>(member->getMemberDecl());
    if (method && is_accessor(method)) return {};
    if (method) return !method->isConst();
    const std::string text = unit_.text(member);
    return way_ == text + "." || way_ == text + "->" ? std::nullopt : std::optional(false);
  }

  const Unit& unit_;
  const std::string& way_;
};

class Finder : public AstVisitor {
 public:
  Finder(const Unit& unit, EntityTable& entities, const StandingMessage& member)
      : unit_(unit),
        entities_(entities),
        id_(member.id),
        object_(object_of(member.expr)),
        is_by_value_(is_by_value(member.expr)),
        way_(way_to(unit, member.expr)),
        hands_on_(unit, way_) {}
  MemberMentions found;

  bool VisitMemberExpr(clang::MemberExpr* member) override { return note(member, member->getMemberDecl()); }
  bool VisitDeclRefExpr(clang::DeclRefExpr* reference) override {
    return note(reference, reference->getDecl());
  }

 private:
  bool note(const clang::Expr* expr, const clang::ValueDecl* decl) {
    const unsigned here = unit_.offset(expr->getBeginLoc());
    if (decl == object_ && hands_on_(expr)) found.object_handed_on = std::min(found.object_handed_on, here);
    if (!llvm::isa<clang::FieldDecl, clang::VarDecl>(decl) || entities_.declare(decl) != id_) return true;
    const bool is_same = way_to(unit_, expr) == way_;
    if (!is_same && !(may_be_the_same(expr) && leaves_pointer(unit_, expr))) return true;
    found.first = std::min(found.first, here);
    if (!names_a_part_without_arrays(unit_.ast(), expr))
      found.first_of_arrays = std::min(found.first_of_arrays, here);
    if (is_same) found.last = std::max(found.last, here);
    return true;
  }
  /// Another name may lead to the same object, unless both name objects that are there by value.
  bool may_be_the_same(const clang::Expr* expr) const { return !(is_by_value_ && is_by_value(expr)); }
  const Unit& unit_;
  EntityTable& entities_;
  const EntityId& id_;
  const clang::ValueDecl* object_;
  bool is_by_value_;
  std::string way_;
  HandsOn hands_on_;
};

/// Frame frame; Frame frame{}; Frame* frame = new Frame; auto frame = make_shared<Frame>();
bool is_made(const clang::Expr* value) {
  if (!value) return true;
  value = value->IgnoreUnlessSpelledInSource();
  if (const auto* made = llvm::dyn_cast<clang::CXXConstructExpr>(value)) {
    if (made->getNumArgs() == 0 || llvm::isa<clang::CXXDefaultArgExpr>(made->getArg(0))) return true;
    return made->getNumArgs() == 1 && is_made(made->getArg(0));
  }
  if (const auto* list = llvm::dyn_cast<clang::InitListExpr>(value))
    return llvm::all_of(list->inits(), is_made);
  if (llvm::isa<clang::CXXNewExpr, clang::CXXScalarValueInitExpr, clang::ImplicitValueInitExpr,
                clang::CXXDefaultInitExpr>(value))
    return true;
  const auto* call = llvm::dyn_cast<clang::CallExpr>(value);
  return call && call->getDirectCallee() && makes_object(call);
}

/// A pointer or reference to what outlives the function.
bool leads_to_what_lasts(const clang::VarDecl* variable) {
  if (variable->isCXXForRangeDecl() || !variable->getInit()) return variable->isCXXForRangeDecl();
  const clang::QualType type = variable->getType();
  if (!type->isReferenceType() && !type->isPointerType()) return false;
  const clang::ValueDecl* begin = begin_of(variable->getInit());
  const auto* other = llvm::dyn_cast_or_null<clang::VarDecl>(begin);
  return begin && (!other || !other->hasLocalStorage());
}

}  // namespace

std::string way_to(const Unit& unit, const clang::Expr* mention) {
  const auto* member = llvm::dyn_cast<clang::MemberExpr>(mention->IgnoreParenImpCasts());
  const clang::Expr* base = member ? member->getBase()->IgnoreParenImpCasts() : nullptr;
  if (!base || llvm::isa<clang::CXXThisExpr>(base)) return "";
  return unit.text(base) + (member->isArrow() ? "->" : ".");
}

MemberMentions mentions_of(const Unit& unit, EntityTable& entities, const StandingMessage& member) {
  Finder finder(unit, entities, member);
  finder.TraverseStmt(member.function->getBody());
  return finder.found;
}

MemberMentions MemberMentions::with_object() const {
  return {std::min(first, object_handed_on), std::min(first_of_arrays, object_handed_on), last,
          object_handed_on};
}

std::string object_that_ends(const clang::Expr* mention) {
  const auto* variable = llvm::dyn_cast_or_null<clang::VarDecl>(object_of(mention));
  const bool ends = variable && variable->hasLocalStorage() && !leads_to_what_lasts(variable);
  return ends ? variable->getNameAsString() : "";
}

bool object_is_made_here(const clang::Expr* mention) {
  const auto* variable = llvm::dyn_cast_or_null<clang::VarDecl>(object_of(mention));
  return variable && !llvm::isa<clang::ParmVarDecl>(variable) && is_made(variable->getInit());
}

}  // namespace tzc::rewriter
