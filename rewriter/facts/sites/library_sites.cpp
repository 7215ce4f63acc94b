// SPDX-License-Identifier: BSD-3-Clause
#include "facts/sites/library_sites.h"

#include "facts/sites/attached_advertise.h"
#include "facts/syntax/call_place.h"
#include "facts/syntax/calls.h"
#include "facts/syntax/library_advertise.h"
#include "facts/syntax/message_type.h"
#include "model/codes.h"

namespace tzc::rewriter {
namespace {

/// Advertises and publishes a message that it keeps, so that no parameter shows it.
constexpr char realtime_publisher[] = "realtime_tools::RealtimePublisher";

bool is_realtime_publisher(const clang::CXXRecordDecl* record) {
  return record && qualified_name_of(record) == realtime_publisher;
}

/// publish(M), publish(M::ConstPtr), publishCloud(M): the first message that such a function takes.
std::optional<MessageType> message_taken(const clang::CXXMethodDecl* method) {
  for (const clang::ParmVarDecl* parameter : method->parameters()) {
    const clang::QualType type = parameter->getType().getNonReferenceType();
    const clang::QualType pointee = type->isPointerType() ? clang::QualType() : pointee_of(type);
    if (const auto message = message_of(pointee.isNull() ? type : pointee)) return message;
  }
  return {};
}

std::optional<MessageType> first_message(const clang::TemplateArgumentList* arguments) {
  if (!arguments || arguments->size() == 0) return {};
  const clang::TemplateArgument& first = (*arguments)[0];
  return first.getKind() == clang::TemplateArgument::Type ? message_of(first.getAsType()) : std::nullopt;
}

std::optional<MessageType> message_of_class(const clang::CXXRecordDecl* record) {
  const auto* templated = llvm::dyn_cast_or_null<clang::ClassTemplateSpecializationDecl>(record);
  return templated ? first_message(&templated->getTemplateArgs()) : std::nullopt;
}

/// The class of such an object, as Facts::library_publishers names it.
std::string library_class(const clang::CXXRecordDecl* record) {
  const clang::ASTContext& context = record->getASTContext();
  return context.getRecordType(record).getAsString();
}

/// What all three kinds of sites have.
void describe(SiteFact& site, const Unit& unit, const clang::Expr* expr, const MessageType& message) {
  set_place(site, unit, expr);
  set_message(site, message);
}

template <class Call>
std::optional<Advertise> advertise(const Unit& unit, const Call* call, const clang::CXXRecordDecl* record) {
  const auto message = message_of_class(record);
  if (!message || call->getNumArgs() < 3) return {};
  Advertise site;
  describe(site, unit, call, *message);
  site.obstacles.push_back(
      {codes::TZC1021, "'" + qualified_name_of(record) + "' advertises it", location_of(site.where)});
  site.topic = constant_string(call->getArg(1));
  return site;
}

}  // namespace

std::optional<Advertise> library_advertise(const Unit& unit, const clang::CXXConstructExpr* construct) {
  const clang::CXXRecordDecl* record = construct->getConstructor()->getParent();
  return is_realtime_publisher(record) ? advertise(unit, construct, record) : std::nullopt;
}

std::optional<Advertise> library_advertise_made(const Unit& unit, const clang::CallExpr* call) {
  const clang::CXXRecordDecl* record = class_that_is_made(call);
  return is_realtime_publisher(record) ? advertise(unit, call, record) : std::nullopt;
}

std::optional<Advertise> library_advertise(const Unit& unit, const clang::CXXMemberCallExpr* call) {
  const clang::CXXMethodDecl* method = call->getMethodDecl();
  const bool advertises = is_realtime_publisher(method->getParent()) && method->getNameAsString() == "init";
  return advertises ? advertise(unit, call, method->getParent()) : std::nullopt;
}

std::optional<Advertise> library_transport(const Unit& unit, const clang::CallExpr* call) {
  const clang::FunctionDecl* function = call->getDirectCallee();
  if (!function || !function->getIdentifier() || !function->getName().starts_with("advertise")) return {};
  const clang::CXXRecordDecl* record = call->getType().getCanonicalType()->getAsCXXRecordDecl();
  const LibraryTransport* rule = record ? unit.rules.find_transport(qualified_name_of(record)) : nullptr;
  if (!rule || unit.declares(function)) return {};
  Advertise site;
  set_place(site, unit, call);
  site.type = rule->message;
  site.library_class = library_class(record);
  site.obstacles.push_back(
      {codes::TZC1021, "'" + qualified_name_of(record) + "' advertises its topics", location_of(site.where)});
  site.attaching.is_done = attaching_call(unit, call, rule->to) != nullptr;
  if (!site.attaching.is_done)
    site.attaching.changes =
        put_around(unit, call, {{}, std::string(rule->to) + "(", rule->rule, {rule->header}}, ")");
  return site;
}

std::optional<Publish> library_publish(const Unit& unit, const clang::CXXMemberCallExpr* call) {
  const clang::CXXMethodDecl* method = call->getMethodDecl();
  const std::string name = method->getNameAsString();
  std::optional<MessageType> message;
  if (is_realtime_publisher(method->getParent()) && name == "unlockAndPublish")
    message = message_of_class(method->getParent());
  else if (llvm::StringRef(name).starts_with("publish") && !unit.declares(method) && !is_publish(call))
    message = message_taken(method);
  if (!message) return {};
  Publish site;
  describe(site, unit, call, *message);
  site.library_class = library_class(method->getParent());
  site.obstacles.push_back({codes::TZC1021, "'" + qualified_name_of(method->getParent()) + "' publishes it",
                            location_of(site.where)});
  return site;
}

void note_given_publishers(const Unit& unit, ValueFlow& flow, const MadeObject& object, Facts& facts) {
  const clang::CXXRecordDecl* record = object.type.isNull() ? nullptr : object.type->getAsCXXRecordDecl();
  if (!record || unit.source.in_package(record->getLocation()) || carried_by(object.type, unit.rules)) return;
  for (const clang::Expr* argument : object.arguments) {
    const auto carried = carried_by(argument->getType(), unit.rules);
    if (!carried || carried->role != EntityRole::publisher) continue;
    const FlowSources sources = flow.sources_of(argument);
    std::set<EntityId>& given = facts.library_publishers[library_class(record)];
    given.insert(sources.entities.begin(), sources.entities.end());
    if (sources.entities.empty() || sources.foreign) given.insert(EntityId());
  }
}

std::optional<Subscribe> library_subscribe(const Unit& unit, const clang::CallExpr* call) {
  const clang::FunctionDecl* function = call->getDirectCallee();
  if (!function || qualified_name_of(function) != "ros::topic::waitForMessage") return {};
  const auto message = first_message(function->getTemplateSpecializationArgs());
  if (!message) return {};
  Subscribe site;
  describe(site, unit, call, *message);
  site.obstacles.push_back(
      {codes::TZC2008, "the call subscribes inside roscpp for one message", location_of(site.where)});
  if (call->getNumArgs() > 0) site.topic = constant_string(call->getArg(0));
  return site;
}

}  // namespace tzc::rewriter
