// SPDX-License-Identifier: BSD-3-Clause
// What runs between a publish and the end of the message's life. A pointer that escaped before is harmless when
// nothing there can write through it, or read what another write has moved away: then it cannot be told from a
// pointer that no code has.
#include <clang/AST/StmtCXX.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>

#include "facts/escape/escape.h"
#include "facts/escape/hidden_calls.h"
#include "facts/escape/quiet_streams.h"
#include "facts/syntax/known_functions.h"
#include "facts/syntax/package_types.h"
#include "model/codes.h"

namespace tzc::rewriter {
namespace {

bool is_message_pointer(EscapeContext& context, clang::QualType type) {
  const auto carried = carried_by(type, context.unit.rules);
  return carried && carried->role == EntityRole::message && !carried->rename;
}

/// Types whose destructors neither run code of the package nor wait, and do not write to elements.
bool ends_quietly(clang::QualType type) {
  if (type->isReferenceType()) return true;
  type = type.getCanonicalType();
  if (type.isDestructedType() == clang::QualType::DK_none) return true;
  const clang::CXXRecordDecl* record = type->getAsCXXRecordDecl();
  if (!record) return false;
  const std::string name = qualified_name_of(record);
  static const std::set<std::string> known = {"cv::Mat",
                                              "cv::Mat_",
                                              "cv_bridge::CvImage",
                                              "pcl::PointCloud",
                                              "pcl::PCLPointCloud2",
                                              "ros::Publisher",
                                              "ros::NodeHandle",
                                              "ros::Rate",
                                              "tf::StampedTransform",
                                              "std::basic_stringstream",
                                              "std::basic_ostringstream"};
  if (known.count(name) || message_of(record) || is_owner_class(name) || is_view_class(name)) return true;
  const bool pointer = record->getName() == "shared_ptr" || record->getName() == "unique_ptr";
  const clang::QualType pointee = pointee_of(type);
  return pointer && !pointee.isNull() &&
         (message_of(pointee) ||
          known.count(pointee->getAsCXXRecordDecl() ? qualified_name_of(pointee->getAsCXXRecordDecl())
                                                    : std::string()));
}

/// Looks for the first thing in a statement that is not known to be quiet.
class QuietCheck {
 public:
  /// `unshown`: hidden code that there is none of.
  QuietCheck(EscapeContext& context, const std::vector<SeenEvent>& events, const IfShown::Names& unshown)
      : context_(context), unshown_(unshown) {
    for (const SeenEvent& seen : events)
      if (seen.event.kind == PublishEvent::Kind::call || seen.event.kind == PublishEvent::Kind::unknown)
        runs_package_[seen.at] = *either(when_package_runs(seen.at), seen.event.if_shown);
  }

  bool ends(clang::QualType type) {
    return ends_quietly(type) && (type->isReferenceType() || !runs(context_.hidden.at_end_of(type)));
  }

  /// Whether its variables, which end later, end quietly.
  bool is_quiet_declaration(const clang::DeclStmt* declaration);

  /// Null: all of it is quiet.
  const clang::Stmt* loud_part(const clang::Stmt* stmt) {
    if (!stmt) return nullptr;
    if (!is_quiet(stmt)) return stmt;
    for (const clang::Stmt* child : stmt->children())
      if (const clang::Stmt* loud = loud_part(child)) return loud;
    return nullptr;
  }
  /// When what was found last is not quiet.
  const IfShown& if_shown() const { return if_shown_; }

 private:
  std::optional<IfShown> when_package_runs(const clang::Stmt* stmt) const {
    const auto runs = runs_package_.find(stmt);
    return runs == runs_package_.end() ? std::nullopt : std::optional(runs->second);
  }
  bool runs(const std::optional<IfShown>& when);
  bool is_quiet(const clang::Stmt* stmt);
  bool is_quiet_call(const clang::CallExpr* call);
  bool is_quiet_target(const clang::Expr* target);
  bool is_quiet_operator(const clang::CXXOperatorCallExpr* call);

  EscapeContext& context_;
  const IfShown::Names& unshown_;
  std::map<const clang::Stmt*, IfShown>
      runs_package_;  ///< may run code of the package, or its variables' ends may
  IfShown if_shown_;
};

/// Whether it may run hidden code, which it then remembers.
bool QuietCheck::runs(const std::optional<IfShown>& when) {
  if (!when || when->is_always()) return when.has_value();
  IfShown::Names left;
  std::set_difference(when->names()->begin(), when->names()->end(), unshown_.begin(), unshown_.end(),
                      std::inserter(left, left.end()));
  if (left.empty()) return false;
  if_shown_ = IfShown(std::move(left));
  return true;
}

/// A variable or member itself, or a plain part of a message: not what a pointer points to.
bool QuietCheck::is_quiet_target(const clang::Expr* target) {
  target = target->IgnoreParenImpCasts();
  if (const auto* reference = llvm::dyn_cast<clang::DeclRefExpr>(target)) {
    const clang::QualType type = reference->getDecl()->getType();
    return llvm::isa<clang::VarDecl>(reference->getDecl()) &&  // a structured binding may name a reference
           (!type->isReferenceType() || is_message_pointer(context_, type));
  }
  if (llvm::isa<clang::CXXThisExpr>(target)) return true;
  if (const auto* op = llvm::dyn_cast<clang::CXXOperatorCallExpr>(target)) {
    const bool follows = op->getOperator() == clang::OO_Arrow || op->getOperator() == clang::OO_Star;
    return follows && is_message_pointer(context_, op->getArg(0)->getType());
  }
  const auto* member = llvm::dyn_cast<clang::MemberExpr>(target);
  if (!member || member->getMemberDecl()->getType()->isReferenceType()) return false;
  const clang::Expr* base = member->getBase()->IgnoreParenImpCasts();
  if (member->isArrow() && !llvm::isa<clang::CXXThisExpr>(base))
    return is_message_pointer(context_, base->getType()) && is_quiet_target(base);
  return is_quiet_target(base);
}

bool QuietCheck::is_quiet_operator(const clang::CXXOperatorCallExpr* call) {
  const clang::OverloadedOperatorKind op = call->getOperator();
  const clang::FunctionDecl* callee = call->getDirectCallee();
  if (!callee || context_.unit.declares(callee)) return false;
  if (op == clang::OO_Arrow || op == clang::OO_Star)
    return is_message_pointer(context_, call->getArg(0)->getType());
  if (op == clang::OO_Equal && runs(context_.hidden.at_end_of(call->getArg(0)->getType()))) return false;
  if (op == clang::OO_Equal || call->isAssignmentOp() || op == clang::OO_PlusPlus)
    return is_quiet_target(call->getArg(0)) && !may_hold_pointer(call->getArg(0)->getType());
  return is_quiet_function(qualified_name_of(callee)) && llvm::all_of(call->arguments(), is_quiet_stream);
}

bool QuietCheck::is_quiet_call(const clang::CallExpr* call) {
  if (const auto* op = llvm::dyn_cast<clang::CXXOperatorCallExpr>(call)) return is_quiet_operator(op);
  const clang::FunctionDecl* callee = call->getDirectCallee();
  if (!callee || context_.unit.declares(callee)) return false;
  const auto* method = llvm::dyn_cast<clang::CXXMemberCallExpr>(call);
  const clang::Expr* object = method ? method->getImplicitObjectArgument() : nullptr;
  if (object && is_data_array(object->getType()->isPointerType() ? object->getType()->getPointeeType()
                                                                 : object->getType()))
    return llvm::isa<clang::MemberExpr>(object->IgnoreParenImpCasts()) &&
           (call->getType()->isVoidType() || call->getType()->isArithmeticType());
  if (object && is_message_pointer(context_, object->getType()) && callee->getNameAsString() == "reset")
    return !runs(context_.hidden.at_end_of(object->getType()));
  if (object && is_message_pointer(context_, object->getType()) &&
      llvm::isa<clang::CXXConversionDecl>(callee))
    return true;
  if (callee->getNameAsString() == "publish" && object &&
      is_publisher_class(qualified_name_of(method->getRecordDecl())))
    return true;
  // std::max(a, b, compare)
  const bool calls_back = llvm::any_of(call->arguments(), [&](const clang::Expr* argument) {
    return involves_package(context_.unit, argument->getType());
  });
  return !calls_back && is_quiet_function(qualified_name_of(callee)) &&
         (!object || is_quiet_stream(object)) && llvm::all_of(call->arguments(), is_quiet_stream);
}

bool QuietCheck::is_quiet_declaration(const clang::DeclStmt* declaration) {
  return !runs(when_package_runs(declaration)) &&
         llvm::all_of(declaration->decls(), [&](const clang::Decl* decl) {
           const auto* variable = llvm::dyn_cast<clang::VarDecl>(decl);
           return !variable || variable->isStaticLocal() || ends(object_type_of(variable));
         });
}

/// What libraries are given may bring code of the package, whatever is known of the functions that are called.
bool QuietCheck::is_quiet(const clang::Stmt* stmt) {
  if (runs(when_package_runs(stmt))) return false;
  if (const auto* call = llvm::dyn_cast<clang::CallExpr>(stmt)) return is_quiet_call(call);
  if (const auto* declaration = llvm::dyn_cast<clang::DeclStmt>(stmt))
    return is_quiet_declaration(declaration);
  if (const auto* made = llvm::dyn_cast<clang::CXXConstructExpr>(stmt))
    return !context_.unit.declares(made->getConstructor()) && ends(made->getType());
  if (const auto* bound = llvm::dyn_cast<clang::CXXBindTemporaryExpr>(stmt)) return ends(bound->getType());
  if (const auto* op = llvm::dyn_cast<clang::BinaryOperator>(stmt))
    return !op->isAssignmentOp() || is_quiet_target(op->getLHS());
  if (const auto* op = llvm::dyn_cast<clang::UnaryOperator>(stmt)) {
    if (op->isIncrementDecrementOp()) return is_quiet_target(op->getSubExpr());
    return op->getOpcode() != clang::UO_Deref || is_message_pointer(context_, op->getSubExpr()->getType());
  }
  // std::cout << manipulator: named, it is called by what gets it.
  if (const auto* reference = llvm::dyn_cast<clang::DeclRefExpr>(stmt))
    if (const auto* function = llvm::dyn_cast<clang::FunctionDecl>(reference->getDecl()))
      return !context_.unit.declares(function);
  if (const auto* member = llvm::dyn_cast<clang::MemberExpr>(stmt)) {
    const clang::Expr* base = member->getBase()->IgnoreParenImpCasts();
    return !member->isArrow() || llvm::isa<clang::CXXThisExpr, clang::CXXOperatorCallExpr>(base) ||
           is_message_pointer(context_, base->getType());
  }
  if (llvm::isa<clang::Expr>(stmt))
    return llvm::isa<clang::DeclRefExpr, clang::CXXThisExpr, clang::IntegerLiteral, clang::FloatingLiteral,
                     clang::StringLiteral, clang::CharacterLiteral, clang::CXXBoolLiteralExpr,
                     clang::CXXNullPtrLiteralExpr, clang::GNUNullExpr, clang::CastExpr, clang::ParenExpr,
                     clang::FullExpr, clang::MaterializeTemporaryExpr, clang::ConditionalOperator,
                     clang::CXXDefaultArgExpr, clang::UnaryExprOrTypeTraitExpr, clang::CXXTemporaryObjectExpr,
                     clang::InitListExpr, clang::PredefinedExpr, clang::SubstNonTypeTemplateParmExpr,
                     clang::CXXScalarValueInitExpr>(stmt);
  return llvm::isa<clang::CompoundStmt, clang::IfStmt, clang::ForStmt, clang::WhileStmt, clang::DoStmt,
                   clang::SwitchStmt, clang::SwitchCase, clang::ReturnStmt, clang::BreakStmt,
                   clang::ContinueStmt, clang::NullStmt, clang::AttributedStmt>(stmt);
}

// ------------------------------------------------------------------------------------------------------------------

/// The local message that an event is about, held by value: its life ends with its block.
const clang::DeclStmt* owner_of(EscapeContext& context, const FunctionView& view, const SeenEvent& event) {
  const auto* call = llvm::dyn_cast<clang::CallExpr>(event.at);
  const clang::DeclStmt* owner = nullptr;
  if (!call) return nullptr;
  for (const clang::Expr* argument : call->arguments()) {
    const auto carried = carried_by(argument->getType(), context.unit.rules);
    if (!carried || carried->role != EntityRole::message) continue;
    const auto* reference = llvm::dyn_cast<clang::DeclRefExpr>(argument->IgnoreParenImpCasts());
    const auto* variable = reference ? llvm::dyn_cast<clang::VarDecl>(reference->getDecl()) : nullptr;
    const bool by_value = variable && variable->isLocalVarDecl() && !variable->isStaticLocal() &&
                          message_of(variable->getType()) && !variable->getType()->isReferenceType();
    if (!by_value || owner) return nullptr;
    owner = view.declaration(variable);
  }
  return owner;
}

/// Goes outwards from an event, over what runs after it.
class Tail {
 public:
  /// `owner`: of the message (owner_of); may be null.
  Tail(const FunctionView& view, const SeenEvent& event, const clang::DeclStmt* owner, QuietCheck check)
      : view_(view), event_(event), check_(std::move(check)), owner_(owner) {}

  const clang::Stmt* loud_part() {
    const bool own_lambda = event_.lambda && owner_ && view_.lambda_around(owner_) == event_.lambda;
    if ((event_.lambda && !own_lambda) || view_.jumps()) return event_.at;
    const clang::Stmt* inner = event_.at;
    for (const clang::Stmt* around = view_.parent(inner); around; around = view_.parent(inner)) {
      if (const clang::Stmt* loud = loud_in(around, inner)) return loud;
      if (owner_ && view_.parent(owner_) == around) return locals_of(around, inner);
      inner = around;
    }
    return inner == view_.function()->getBody() ? nullptr : event_.at;  // not in a constructor's initializer
  }
  const IfShown& if_shown() const { return check_.if_shown(); }

 private:
  const clang::Stmt* loud_in(const clang::Stmt* around, const clang::Stmt* inner) {
    if (const auto* block = llvm::dyn_cast<clang::CompoundStmt>(around)) return after(block, inner);
    if (const auto* guarded = llvm::dyn_cast<clang::CXXTryStmt>(around)) return handlers(guarded);
    if (llvm::isa<clang::ForStmt, clang::WhileStmt, clang::DoStmt, clang::CXXForRangeStmt>(around))
      return check_.loud_part(around);
    if (llvm::isa<clang::Expr>(around) && !llvm::isa<clang::FullExpr>(around)) return siblings(around, inner);
    if (const auto* choice = llvm::dyn_cast<clang::IfStmt>(around))
      return inner == choice->getThen() || inner == choice->getElse() ? nullptr : siblings(around, inner);
    if (const auto* choice = llvm::dyn_cast<clang::SwitchStmt>(around))
      return inner == choice->getBody() ? nullptr : siblings(around, inner);
    if (llvm::isa<clang::DeclStmt>(around)) return siblings(around, inner);
    return llvm::isa<clang::FullExpr, clang::SwitchCase, clang::ReturnStmt, clang::AttributedStmt>(around)
               ? nullptr
               : around;
  }
  /// Other operands may be evaluated after the event.
  const clang::Stmt* siblings(const clang::Stmt* around, const clang::Stmt* inner) {
    for (const clang::Stmt* child : around->children())
      if (child != inner)
        if (const clang::Stmt* loud = check_.loud_part(child)) return loud;
    const auto* call = llvm::dyn_cast<clang::CallExpr>(around);
    return call ? around : nullptr;
  }
  const clang::Stmt* after(const clang::CompoundStmt* block, const clang::Stmt* inner) {
    bool behind = false;
    for (const clang::Stmt* stmt : block->body()) {
      if (behind)
        if (const clang::Stmt* loud = check_.loud_part(stmt)) return loud;
      behind |= stmt == inner;
    }
    return locals_of(block, inner);
  }
  /// Locals that were declared before the event, but after the message, end before it.
  const clang::Stmt* locals_of(const clang::Stmt* block, const clang::Stmt* inner) {
    const auto* compound = llvm::dyn_cast<clang::CompoundStmt>(block);
    if (!compound) return nullptr;
    for (const clang::Stmt* stmt : compound->body()) {
      if (stmt == inner) return nullptr;
      if (owner_ && view_.span(stmt).enter < view_.span(owner_).enter) continue;
      const auto* declaration = llvm::dyn_cast<clang::DeclStmt>(stmt);
      if (declaration && !check_.is_quiet_declaration(declaration)) return stmt;
    }
    return nullptr;
  }
  const clang::Stmt* handlers(const clang::CXXTryStmt* guarded) {
    for (unsigned i = 0; i < guarded->getNumHandlers(); ++i)
      if (const clang::Stmt* loud = check_.loud_part(guarded->getHandler(i)->getHandlerBlock())) return loud;
    return nullptr;
  }

  const FunctionView& view_;
  const SeenEvent& event_;
  QuietCheck check_;
  const clang::DeclStmt* owner_;
};

}  // namespace

void note_tail(EscapeContext& context, const FunctionView& view, const std::vector<SeenEvent>& events,
               const SeenEvent& event) {
  const clang::DeclStmt* owner = owner_of(context, view, event);
  IfShown::Names unshown;
  for (;;) {
    Tail tail(view, event, owner, QuietCheck(context, events, unshown));
    const clang::Stmt* loud = tail.loud_part();
    if (!loud) return;
    context.found.loud_tails.push_back(
        {event.event,
         {codes::TZC1003, "a pointer into its data escaped, and this runs before the message ends",
          location_of(context.unit.source.where(loud->getBeginLoc()))},
         tail.if_shown()});
    if (tail.if_shown().is_always()) return;
    unshown.insert(tail.if_shown().names()->begin(), tail.if_shown().names()->end());
  }
}

}  // namespace tzc::rewriter
