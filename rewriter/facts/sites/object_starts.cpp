// SPDX-License-Identifier: BSD-3-Clause
#include "facts/sites/object_starts.h"

#include <clang/AST/ExprCXX.h>
#include <llvm/ADT/STLExtras.h>

#include <set>
#include <string>

#include "facts/syntax/ast_walk.h"
#include "facts/syntax/calls.h"
#include "facts/syntax/message_type.h"

namespace tzc::rewriter {

namespace {

bool keeps_node_alive(const clang::CXXRecordDecl* record) {
  static const std::set<std::string> classes = {"ros::NodeHandle",
                                                "ros::Subscriber",
                                                "ros::Timer",
                                                "ros::WallTimer",
                                                "ros::SteadyTimer",
                                                "ros::ServiceServer",
                                                "nodelet::Nodelet",
                                                "image_transport::ImageTransport",
                                                "image_transport::Subscriber",
                                                "image_transport::CameraSubscriber"};
  return record && classes.count(qualified_name_of(record)) != 0;
}

/// An object that subscribes, or holds the node or a timer, is made to live on: whoever made one for each message would connect for each message,
/// and a copy would be the least of it. Of any other class a library may make new objects unseen (emplace_back(), a map's []), each with
/// a new message.
bool lives_long(const clang::CXXRecordDecl* record) {
  if (!record || !record->hasDefinition()) return false;
  record = record->getDefinition();
  return llvm::any_of(record->fields(),
                      [](const clang::FieldDecl* field) {
                        return keeps_node_alive(field->getType()->getAsCXXRecordDecl());
                      }) ||
         llvm::any_of(record->bases(), [](const clang::CXXBaseSpecifier& base) {
           const clang::CXXRecordDecl* of = base.getType()->getAsCXXRecordDecl();
           return keeps_node_alive(of) || lives_long(of);
         });
}

}  // namespace

std::optional<LastingStart> lasting_start(const FlowEnd& end) {
  if (end.variable && !end.variable->hasLocalStorage())  // its statement may run again
    return end.variable->getTLSKind() == clang::VarDecl::TLS_None
               ? std::optional(LastingStart{usr_of(end.variable), false})
               : std::nullopt;
  if (!end.member || !lives_long(llvm::dyn_cast<clang::CXXRecordDecl>(end.member->getParent()))) return {};
  const clang::QualType pointee = pointee_of(end.member->getType());
  return !pointee.isNull() && message_of(pointee) ? std::optional(LastingStart{usr_of(end.member), true})
                                                  : std::nullopt;
}

bool is_always_made(const Unit& unit, const clang::Expr* made) {
  for (const clang::DynTypedNode& node : ancestors(unit.ast(), *made)) {
    const auto* expr = node.get<clang::Expr>();
    const auto* op = llvm::dyn_cast_or_null<clang::BinaryOperator>(expr);
    const auto* call = llvm::dyn_cast_or_null<clang::CXXOperatorCallExpr>(expr);
    if (!expr) break;
    if (llvm::isa<clang::AbstractConditionalOperator>(expr) ||
        (op && (op->isLogicalOp() || op->isCommaOp())) || (call && call->getOperator() == clang::OO_Comma))
      return false;
  }
  return true;
}

bool is_in_initializer_list(const Unit& unit, const clang::Expr* made) {
  for (const clang::DynTypedNode& node : ancestors(unit.ast(), *made))
    if (!node.get<clang::Expr>()) return node.get<clang::CXXConstructorDecl>() != nullptr;
  return false;
}

}  // namespace tzc::rewriter
