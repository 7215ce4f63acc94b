// SPDX-License-Identifier: BSD-3-Clause
#include "facts/library_sites.h"

#include "facts/ast_walk.h"
#include "facts/calls.h"
#include "facts/message_type.h"
#include "model/codes.h"

namespace tzc::rewriter {
namespace {

struct PublishingClass {
  const char* name;       ///< a template of the message
  const char* publish;    ///< the member function that publishes
  const char* advertise;  ///< that advertises, besides the constructor; null: it is given a publisher
};

constexpr PublishingClass publishing_classes[] = {
    {"realtime_tools::RealtimePublisher", "unlockAndPublish", "init"},
    {"diagnostic_updater::DiagnosedPublisher", "publish", nullptr},
};

const PublishingClass* publishing_class(const clang::CXXRecordDecl* record) {
  if (!record) return nullptr;
  const std::string name = qualified_name_of(record);
  for (const PublishingClass& one : publishing_classes)
    if (name == one.name) return &one;
  return nullptr;
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

/// What all three kinds of sites have.
void describe(SiteFact& site, const Unit& unit, const clang::Expr* expr, const MessageType& message) {
  site.where = unit.source.where(expr->getExprLoc());
  site.function = enclosing_function_name(unit.ast(), *expr);
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
  const PublishingClass* known = publishing_class(record);
  return known && known->advertise ? advertise(unit, construct, record) : std::nullopt;
}

std::optional<Advertise> library_advertise(const Unit& unit, const clang::CXXMemberCallExpr* call) {
  const clang::CXXRecordDecl* record = call->getMethodDecl()->getParent();
  const PublishingClass* known = publishing_class(record);
  if (!known || !known->advertise || call->getMethodDecl()->getNameAsString() != known->advertise) return {};
  return advertise(unit, call, record);
}

std::optional<Publish> library_publish(const Unit& unit, const clang::CXXMemberCallExpr* call) {
  const clang::CXXRecordDecl* record = call->getMethodDecl()->getParent();
  const PublishingClass* known = publishing_class(record);
  const auto message = known ? message_of_class(record) : std::nullopt;
  if (!message || call->getMethodDecl()->getNameAsString() != known->publish) return {};
  Publish site;
  describe(site, unit, call, *message);
  site.obstacles.push_back(
      {codes::TZC1021, "'" + qualified_name_of(record) + "' publishes it", location_of(site.where)});
  return site;
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
