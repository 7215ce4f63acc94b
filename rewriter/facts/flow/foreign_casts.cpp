// SPDX-License-Identifier: BSD-3-Clause
#include "facts/flow/foreign_casts.h"

#include "facts/syntax/calls.h"
#include "facts/syntax/message_type.h"

namespace tzc::rewriter {
namespace {

constexpr unsigned deepest_member = 6;

std::optional<MessageType> message_in(const Unit& unit, clang::QualType type) {
  const std::optional<Carried> carried = carried_by(type, unit.rules);
  return carried ? carried->message : std::nullopt;
}

/// The same in the members of a class of the package, which hold it themselves.
std::optional<MessageType> message_in_parts(const Unit& unit, clang::QualType type, unsigned depth) {
  if (std::optional<MessageType> message = message_in(unit, type)) return message;
  const clang::CXXRecordDecl* record = type->getAsCXXRecordDecl();
  if (!record || !record->hasDefinition() || depth > deepest_member) return {};
  for (const clang::FieldDecl* field : record->getDefinition()->fields())
    if (std::optional<MessageType> message = message_in_parts(unit, field->getType(), depth + 1))
      return message;
  return {};
}

/// A pointer to a message of another type is something else, too: one message may begin with the other.
std::optional<ForeignCast> between(const Unit& unit, clang::QualType from, clang::QualType to) {
  const std::optional<MessageType> message = message_in(unit, to);
  if (!message) return {};
  const std::optional<MessageType> before = message_in(unit, from);
  if (before && before->name == message->name) return {};
  return ForeignCast{message->name, "a message that may be this one is " + cast_from(from)};
}

bool are_related(clang::QualType one, clang::QualType other) {
  const clang::CXXRecordDecl* a = one.isNull() ? nullptr : one->getAsCXXRecordDecl();
  const clang::CXXRecordDecl* b = other.isNull() ? nullptr : other->getAsCXXRecordDecl();
  if (!a || !b || !a->hasDefinition() || !b->hasDefinition()) return false;
  return a->isDerivedFrom(b) || b->isDerivedFrom(a);
}

}  // namespace

bool keeps_bits(const clang::CastExpr* cast) {
  switch (cast->getCastKind()) {
    case clang::CK_BitCast:
    case clang::CK_LValueBitCast:
    case clang::CK_LValueToRValueBitCast:
    case clang::CK_IntegralToPointer:
      return true;
    default:
      return false;
  }
}

std::optional<ForeignCast> foreign_cast(const Unit& unit, const clang::ExplicitCastExpr* cast) {
  const clang::Expr* from = cast->getSubExprAsWritten();
  if (!keeps_bits(cast) || is_null(unit, from)) return {};
  return between(unit, from->getType(), cast->getType());
}

std::optional<ForeignCast> foreign_cast(const Unit& unit, const clang::CallExpr* call) {
  if (!casts_pointer(call->getDirectCallee()) || call->getNumArgs() != 1) return {};
  const clang::QualType from = call->getArg(0)->getType();
  if (are_related(pointee_of(from), pointee_of(call->getType()))) return {};
  return between(unit, from, call->getType());
}

std::optional<ForeignCast> foreign_cast(const Unit& unit, const clang::MemberExpr* member) {
  const auto* field = llvm::dyn_cast<clang::FieldDecl>(member->getMemberDecl());
  if (!field || !field->getParent()->isUnion() || field->getType()->isDependentType()) return {};
  const std::optional<MessageType> message = message_in_parts(unit, field->getType(), 0);
  if (!message) return {};
  return ForeignCast{
      message->name,
      "a message that may be this one is taken from a union, another member of which may have been set"};
}

}  // namespace tzc::rewriter
