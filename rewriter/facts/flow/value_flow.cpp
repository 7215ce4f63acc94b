// SPDX-License-Identifier: BSD-3-Clause
#include "facts/flow/value_flow.h"

#include <clang/AST/StmtCXX.h>

#include <array>

#include "facts/flow/message_copies.h"
#include "facts/syntax/calls.h"
#include "model/codes.h"

namespace tzc::rewriter {
namespace {

bool is_writable(clang::QualType type) {
  return !type.isNull() && !type.isConstQualified() && message_of(type);
}

constexpr const char* loses_its_const = "const is cast away from a message that may be this one";
constexpr const char* is_given_out = "a ros::MessageEvent is told to give out the message without a copy";
constexpr const char* of_cast_function =
    "a function that is cast to another type may be given this message, and write to it";

std::string cast_of_something(clang::QualType from) {
  return "a message that may be this one is " + cast_from(from);
}

/// static_cast<ImagePtr>(tagged), by a conversion function of the package: it is looked at as any function that is called.
bool converts_by_class(const Unit& unit, const clang::ExplicitCastExpr* cast) {
  const auto* call = llvm::dyn_cast_or_null<clang::CXXMemberCallExpr>(call_behind(cast->getSubExpr()));
  const clang::FunctionDecl* function = call ? call->getMethodDecl() : nullptr;
  return llvm::isa_and_nonnull<clang::CXXConversionDecl>(function) && unit.declares_all_of(function);
}

/// ImagePtr(loan), where a Loan is an ImagePtr: it was made from one, so nothing else is taken for a message here.
bool takes_base(const clang::ExplicitCastExpr* cast) {
  const auto record_of = [](clang::QualType type) {
    return type.getNonReferenceType()->getAsCXXRecordDecl();
  };
  const clang::CXXRecordDecl* object = record_of(cast->getSubExprAsWritten()->getType());
  const clang::CXXRecordDecl* base = record_of(cast->getType());
  return object && base && object->hasDefinition() && base->hasDefinition() && object->isDerivedFrom(base);
}

/// An object, or what a pointer points to.
bool is_writable_message(const clang::Expr* expr) {
  const clang::QualType pointee = pointee_of(expr->getType());
  return is_writable(pointee.isNull() ? expr->getType() : pointee);
}

/// &x -> x
const clang::Expr* address_taken(const clang::Expr* expr) {
  expr = expr->IgnoreParenImpCasts();
  const auto* op = llvm::dyn_cast<clang::UnaryOperator>(expr);
  return op && op->getOpcode() == clang::UO_AddrOf ? op->getSubExpr()->IgnoreParenImpCasts() : expr;
}

const clang::FunctionDecl* called_by(const clang::Expr* value) {
  const clang::CallExpr* call = value ? call_behind(value) : nullptr;
  return call ? call->getDirectCallee() : nullptr;
}

/// begin(), and the iterator's operator*. Null: the loop calls none, or it is not known yet.
std::array<const clang::FunctionDecl*, 2> functions_of(const clang::CXXForRangeStmt* loop) {
  const clang::DeclStmt* begin = loop->getBeginStmt();
  const auto* first =
      begin && begin->isSingleDecl() ? llvm::cast<clang::VarDecl>(begin->getSingleDecl()) : nullptr;
  return {called_by(first ? first->getInit() : nullptr), called_by(loop->getLoopVariable()->getInit())};
}

}  // namespace

FlowSources ValueFlow::sources_of(const clang::Expr* expr, EntityRole role) {
  FlowSources sources = sources_.of(expr);
  const auto has_other_role = [&](const EntityId& id) { return entities_[id].role != role; };
  sources.foreign |= llvm::any_of(sources.entities, has_other_role);
  llvm::erase_if(sources.entities, has_other_role);
  return sources;
}

void ValueFlow::check_source_of(const clang::VarDecl* variable) {
  const EntityId id = entities_.declare(variable);
  if (id.empty() || !variable->getInit() || variable->isCXXForRangeDecl() || variable->isImplicit()) return;
  if (llvm::isa<clang::ParmVarDecl>(variable) || variable->getInit()->isTypeDependent()) return;
  if (!sources_of(variable->getInit()).foreign) return;
  if (later_copy(unit_, variable)) return entities_.add_data_use(id, variable->getLocation());
  entities_.add_obstacle(id, entities_.is_message(id) ? codes::TZC1013 : codes::TZC1017,
                         "it starts as '" + unit_.text(variable->getInit()) + "', which " +
                             builder_of(variable->getInit()) + " builds",
                         variable->getLocation());
}

void ValueFlow::check_const_cast(const clang::ExplicitCastExpr* cast) {
  const clang::Expr* from = cast->getSubExpr();
  note_writable(cast);
  add_foreign(foreign_cast(unit_, cast), cast->getBeginLoc());
  for (const clang::QualType message : messages_of_cast_function(unit_, cast))
    add_writable({message, {}, of_cast_function}, cast->getBeginLoc());
  if (!removes_const(cast) || !carried_by(from->getType(), unit_.rules)) return;
  if (serves_plain_field(unit_, cast)) return;
  for (const EntityId& id : sources_of(from).entities)
    entities_.add_obstacle(id, codes::TZC2002, "const is cast away from it", cast->getBeginLoc());
}

/// A message that code can write to from here on, or an array of one, where it was const, or of no type, before.
void ValueFlow::note_writable(const clang::ExplicitCastExpr* cast) {
  const clang::Expr* from = cast->getSubExprAsWritten();
  if (removes_const(cast)) {
    const auto* array = llvm::dyn_cast<clang::MemberExpr>(address_taken(from));
    const clang::Expr* message = array && is_data_array(array->getType()) ? array->getBase() : from;
    if (message == from && serves_plain_field(unit_, cast)) return;
    const clang::Expr* of_type = carried_by(message->getType(), unit_.rules) ? message : cast;
    return add_writable({of_type->getType(), sources_of(message).entities, loses_its_const},
                        cast->getBeginLoc());
  }
  note_as_bytes(cast);
  if (!is_writable_message(cast) || carried_by(from->getType(), unit_.rules) || is_null(unit_, from)) return;
  if (takes_base(cast))
    entities_.add_obstacle(entities_.declare_temporary(cast), codes::TZC1001,
                           "it is the part of an object of '" + from->getType().getAsString() + "'",
                           cast->getBeginLoc());
  else if (!converts_by_class(unit_, cast))
    add_writable({cast->getType(), {}, cast_of_something(from->getType())}, cast->getBeginLoc());
}

void ValueFlow::check_call(const clang::CallExpr* call) {
  for (const clang::Expr* argument : call->arguments()) note_as_bytes(argument);
  add_foreign(foreign_cast(unit_, call), call->getBeginLoc());
  if (const auto event = uncopied_event(unit_, call)) note_event(*event, call->getBeginLoc());
  const clang::FunctionDecl* function = call->getDirectCallee();
  note_foreign_body(call, function);
  if (!function || call->getNumArgs() != 1 || !is_writable_message(call)) return;
  const clang::Expr* from = call->getArg(0);
  if (!casts_pointer(function) || is_writable_message(from) || serves_plain_field(unit_, call)) return;
  const bool is_message = carried_by(from->getType(), unit_.rules).has_value();
  add_writable({call->getType(), sources_of(from).entities,
                is_message ? loses_its_const : cast_of_something(from->getType())},
               call->getBeginLoc());
}

void ValueFlow::check_construction(const clang::CXXConstructExpr* construct) {
  if (const auto event = uncopied_event(unit_, construct)) note_event(*event, construct->getBeginLoc());
  note_foreign_body(construct, construct->getConstructor());
}

/// The message may be an argument, the object, part of either, or what the function has kept.
template <class Call>
void ValueFlow::note_foreign_body(const Call* call, const clang::FunctionDecl* function) {
  const clang::QualType message =
      function && !unit_.declares(function) ? bodies_.loses_const(function) : clang::QualType();
  if (message.isNull()) return;
  const std::string reason =
      "'" + qualified_name_of(function) + "' casts const away from a message that may be this one";
  for (const clang::Expr* argument : call->arguments())
    for (const EntityId& id : sources_of(argument).entities)
      if (entities_.is_message(id)) entities_.add_obstacle(id, codes::TZC2002, reason, call->getBeginLoc());
  add_writable({message, {}, reason}, call->getBeginLoc());
}

void ValueFlow::note_event(const UncopiedEvent& event, clang::SourceLocation where) {
  const bool is_known = carried_by(event.message, unit_.rules) || !event.from;
  const clang::QualType message = is_known ? event.message : event.from->getType();
  const std::vector<EntityId> messages =
      event.from ? sources_of(event.from).entities : std::vector<EntityId>();
  for (const EntityId& id : messages) entities_.add_obstacle(id, codes::TZC2002, is_given_out, where);
  add_writable({message, messages, is_given_out}, where);
}

/// va_arg(list, Image*): what was passed may have been a pointer to a const one.
void ValueFlow::check_variable_argument(const clang::VAArgExpr* argument) {
  if (is_writable(pointee_of(argument->getType())))
    add_writable({argument->getType(), {}, loses_its_const}, argument->getBeginLoc());
}

/// memcpy(&image, &other, sizeof(image)): a pointer to a message is written to as bytes.
void ValueFlow::note_as_bytes(const clang::Expr* converted) {
  const clang::QualType pointer = pointee_of(converted->IgnoreParenCasts()->getType());
  const clang::QualType now = pointee_of(converted->getType());
  const bool is_bytes = !now.isNull() && !now.isConstQualified() && !now->isAnyPointerType();
  if (is_bytes && !pointer.isNull() && !pointer.isConstQualified() && pointer->isPointerType() &&
      is_writable(pointer->getPointeeType()))
    add_writable({pointer, {}, loses_its_const}, converted->getBeginLoc());
}

/// Of a union, which may have been given a pointer to a const one.
void ValueFlow::check_union(const clang::MemberExpr* member) {
  add_foreign(foreign_cast(unit_, member), member->getMemberLoc());
  const auto* field = llvm::dyn_cast<clang::FieldDecl>(member->getMemberDecl());
  if (field && field->getParent()->isUnion() && is_writable(pointee_of(field->getType())))
    add_writable({field->getType(), {}, loses_its_const}, member->getMemberLoc());
}

void ValueFlow::add_writable(Writable writable, clang::SourceLocation where) {
  const std::optional<Carried> carried = carried_by(writable.type, unit_.rules);
  if (carried && carried->message)
    const_casts_.push_back({carried->message->name,
                            std::move(writable.messages),
                            {codes::TZC2002, std::move(writable.reason), unit_.location(where)}});
}

void ValueFlow::add_foreign(const std::optional<ForeignCast>& cast, clang::SourceLocation where) {
  if (cast && unit_.source.in_package(where))
    foreign_casts_.push_back({cast->type, {}, {codes::TZC1001, cast->reason, unit_.location(where)}});
}

void ValueFlow::loop_over(const clang::CXXForRangeStmt* loop) {
  const EntityId variable = loop->getLoopVariable() ? entities_.declare(loop->getLoopVariable()) : EntityId();
  if (variable.empty() || !loop->getRangeInit()) return;
  for (const EntityId& id : sources_of(loop->getRangeInit()).entities)
    entities_.add_flow(id, variable, {loop->getForLoc(), "looped over"});
  for (const clang::FunctionDecl* function : functions_of(loop))
    if (unit_.declares(function))
      entities_.add_flow(entities_.declare_result(function), variable, {loop->getForLoc(), "looped over"});
}

}  // namespace tzc::rewriter
