// SPDX-License-Identifier: BSD-3-Clause
#include "facts/sites/publish_sites.h"

#include "facts/sites/argument_order.h"
#include "facts/sites/containing_object.h"
#include "facts/syntax/ast_walk.h"
#include "facts/syntax/call_place.h"
#include "facts/syntax/calls.h"
#include "model/codes.h"

namespace tzc::rewriter {
namespace {

/// The node directly around a call, cleanups aside.
std::optional<clang::DynTypedNode> node_around(const Unit& unit, const clang::Expr* call) {
  for (const clang::DynTypedNode& node : ancestors(unit.ast(), *call))
    if (!node.get<clang::ExprWithCleanups>()) return node;
  return {};
}

CallStatement statement_of(const Unit& unit, const clang::Expr* call) {
  CallStatement statement;
  const clang::FunctionDecl* function = enclosing_function(unit.ast(), *call);
  statement.in_void_function = function && function->getReturnType()->isVoidType();
  const std::optional<clang::DynTypedNode> around = node_around(unit, call);
  if (!around) return statement;
  statement.in_block = around->get<clang::CompoundStmt>() != nullptr;
  if (statement.in_block || around->get<clang::IfStmt>() || around->get<clang::ForStmt>())
    statement.begin = unit.source.before(call->getBeginLoc()).value_or(Place());
  statement.end = unit.source.behind(call->getSourceRange()).value_or(Place());
  if (statement.end.file.empty()) statement.begin = Place();
  return statement;
}

/// The written argument, without the conversions that the call implies.
const clang::Expr* written(const clang::Expr* expr) {
  for (;;) {
    const clang::Expr* next = expr->IgnoreImplicit();
    const auto* construct = llvm::dyn_cast<clang::CXXConstructExpr>(next);
    if (construct && !llvm::isa<clang::CXXTemporaryObjectExpr>(construct) && construct->getNumArgs() >= 1 &&
        !construct->isListInitialization())
      next = construct->getArg(0);
    if (next == expr) return expr;
    expr = next;
  }
}

bool is_nested(const MessageType& message) {
  return message.has_data_part && !message.has_direct_data_part;
}

/// Reads the argument's type. False: nothing more is known about the message.
bool describe_type(Publish& site, const Unit& unit, const clang::Expr* argument) {
  const clang::QualType type = argument->getType();
  const clang::QualType pointee = pointee_of(type);
  const clang::QualType published = pointee.isNull() ? type : pointee;
  if (const auto twin = twin_message_of(published)) {
    site.type = twin->name;
    site.twin = true;
    site.nested_only = is_nested(*twin);
    return false;
  }
  if (const std::optional<MessageType> message = message_of(published)) {
    set_message(site, *message);
    site.nested_only = is_nested(*message);
  } else if (is_pcl_cloud(type)) {
    site.type = "sensor_msgs/PointCloud2";
    site.pcl = true;
  } else if (is_cv_image(type)) {
    site.type = "sensor_msgs/Image";
    site.pcl = site.by_serializer = true;
  } else {
    site.type = type.getAsString();
    site.obstacles.push_back({codes::TZC1012, "the type of what is published is '" + site.type + "'",
                              unit.location(argument->getBeginLoc())});
  }
  return true;
}

void describe_message(Publish& site, const Unit& unit, ValueFlow& flow, const clang::Expr* argument) {
  if (!describe_type(site, unit, argument)) return;
  const clang::QualType pointee = pointee_of(argument->getType());
  const bool is_message = message_of(pointee.isNull() ? argument->getType() : pointee).has_value();
  const FlowSources sources = flow.sources_of(argument, EntityRole::message);
  site.messages = sources.entities;
  if (flow.sources_of(argument).entities.size() != sources.entities.size())
    site.obstacles.push_back({codes::TZC1001, "it lies beside a publisher or filter in one pair or tuple",
                              unit.location(argument->getBeginLoc())});
  else if (sources.foreign && is_message && site.has_data_part)
    site.obstacles.push_back({codes::TZC1013, builder_of(argument) + " builds the message",
                              unit.location(argument->getBeginLoc())});
}

std::string object_text(const Unit& unit, const clang::Expr* argument) {
  if (!argument->isLValue() ||
      llvm::isa<clang::CallExpr>(argument) != llvm::isa<clang::CXXOperatorCallExpr>(argument))
    return "";
  const std::string text = unit.text(argument);
  return pointee_of(argument->getType()).isNull() ? text : "*" + text;
}

/// No allocation is written for the elements of an object.
std::optional<LocalObject> object_around(const clang::Expr* argument) {
  if (!pointee_of(argument->getType()).isNull()) return {};
  if (const clang::VarDecl* object = object_that_ends(argument))
    return LocalObject{object->getNameAsString(), !is_made_empty(object)};
  const clang::VarDecl* object = object_of_element_that_ends(argument);
  return object ? std::optional(LocalObject{object->getNameAsString(), true}) : std::nullopt;
}

void describe_object(Publish& site, const Unit& unit, const clang::Expr* argument) {
  site.object = object_text(unit, argument);
  site.part_of = object_around(argument);
}

std::optional<PublisherMention> describe_publisher(PublishCall& result, const Unit& unit, ValueFlow& flow,
                                                   const clang::CXXMemberCallExpr* call) {
  Publish& site = result.site;
  const Receiver receiver = receiver_of(call);
  if (!receiver.expr) return {};
  result.publishers = flow.sources_of(receiver.expr, EntityRole::publisher);
  if (!result.publishers.entities.empty()) site.publisher = result.publishers.entities[0];
  site.publisher_text = unit.text(receiver.expr) + (receiver.pointer ? "->" : ".");
  return PublisherMention{receiver.expr,
                          receiver.pointer,
                          site.publisher,
                          site.messages,
                          enclosing_function(unit.ast(), *call),
                          site.where.begin,
                          unit.text(call->getArg(0))};
}

/// Empty: nothing stands in the way. A template's instances may have publishers of several classes.
std::string why_not_attached(const Unit& unit, const clang::CXXMemberCallExpr* call) {
  if (is_instance(enclosing_function(unit.ast(), *call))) return "the call stands in a template";
  if (order_matters(unit, call)) return "tzc::publish would evaluate it at another time than its message";
  const auto* callee = llvm::cast<clang::MemberExpr>(call->getCallee()->IgnoreParens());
  return callee->hasExplicitTemplateArgs() ? "the call names its template arguments" : "";
}

/// What a publisher of other code needs.
void describe_attaching(Publish& site, const Unit& unit, const clang::CXXMemberCallExpr* call) {
  const MethodCall* rule = unit.rules.find_method(qualified_name_of(call->getMethodDecl()->getParent()),
                                                  "publish", written_arguments(call));
  if (!rule) return;
  site.attaching.why_not = why_not_attached(unit, call);
  if (!site.attaching.why_not.empty()) return;
  site.attaching.changes = receiver_first(unit, call, {rule->to, rule->rule, rule->header});
  if (site.attaching.changes.empty()) site.attaching.why_not = "the call comes from a macro";
}

std::vector<EntityId> messages_among(const Unit& unit, ValueFlow& flow, const clang::CallExpr* call) {
  std::vector<EntityId> messages;
  for (const clang::Expr* argument : call->arguments()) {
    const auto carried = carried_by(argument->getType(), unit.rules);
    if (!carried || carried->role != EntityRole::message) continue;
    const FlowSources sources = flow.sources_of(argument, EntityRole::message);
    messages.insert(messages.end(), sources.entities.begin(), sources.entities.end());
  }
  return messages;
}

}  // namespace

std::optional<PublishCall> publish_call(const Unit& unit, ValueFlow& flow,
                                        const clang::CXXMemberCallExpr* call) {
  if (call->getNumArgs() == 0 || call->isTypeDependent()) return {};
  PublishCall result;
  Publish& site = result.site;
  set_place(site, unit, call);
  site.statement = statement_of(unit, call);
  const clang::Expr* argument = written(call->getArg(0));
  if (argument->isTypeDependent()) return {};
  describe_message(site, unit, flow, argument);
  describe_object(site, unit, argument);
  result.publisher = describe_publisher(result, unit, flow, call);
  describe_attaching(site, unit, call);
  if (is_single_subscriber(qualified_name_of(call->getRecordDecl())))
    site.obstacles.push_back(
        {codes::TZC1014, "the message is sent to one subscriber only", location_of(site.where)});
  else if (site.publisher.empty() || (result.publishers.entities.size() > 1 && result.publishers.foreign))
    site.obstacles.push_back(
        {codes::TZC1017, "the publisher is not one of the package", location_of(site.where)});
  return result;
}

Publish attached_publish(const Unit& unit, ValueFlow& flow, const clang::CallExpr* call) {
  Publish site;
  site.attaching.is_done = true;
  set_place(site, unit, call);
  const clang::Expr* argument = written(call->getArg(1));
  describe_message(site, unit, flow, argument);
  describe_object(site, unit, argument);
  const FlowSources publishers = flow.sources_of(call->getArg(0), EntityRole::publisher);
  if (!publishers.entities.empty()) site.publisher = publishers.entities[0];
  return site;
}

std::vector<PublisherMention> publisher_arguments(const Unit& unit, ValueFlow& flow,
                                                  const clang::CallExpr* call) {
  std::vector<PublisherMention> mentions;
  if (llvm::isa<clang::CXXOperatorCallExpr>(call) || !unit.declares(call->getDirectCallee())) return mentions;
  for (const clang::Expr* argument : call->arguments()) {
    const auto carried = carried_by(argument->getType(), unit.rules);
    if (!carried || carried->role != EntityRole::publisher) continue;
    const FlowSources sources = flow.sources_of(argument, EntityRole::publisher);
    if (sources.entities.empty()) continue;
    mentions.push_back({argument->IgnoreImplicit(), !pointee_of(argument->getType()).isNull(),
                        sources.entities[0], messages_among(unit, flow, call),
                        enclosing_function(unit.ast(), *call), unit.offset(call->getBeginLoc())});
  }
  return mentions;
}

}  // namespace tzc::rewriter
