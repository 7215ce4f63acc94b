// SPDX-License-Identifier: BSD-3-Clause
// Libraries that publish or subscribe on the package's behalf. Their own code is out of reach, so their sites
// stay on TCPROS; the report names them.
#include "facts/unit.h"
#include "report/codes.h"

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
template <class Site>
Site site_at(Unit& unit, const clang::Expr* expr, const MessageType& message, const char* code,
             const std::string& reason) {
  Site site;
  site.where = unit.source.where(expr->getExprLoc());
  site.function = function_name_around(unit, *expr);
  site.type = message.name;
  site.heavy = message.has_data;
  site.obstacles.push_back({code, reason, location_of(site.where)});
  return site;
}

std::string id_of(const Place& where, const std::string& type) {
  return where.file + ":" + std::to_string(where.begin) + "<" + type;
}

void add_advertise(Unit& unit, const clang::Expr* expr, const clang::CXXRecordDecl* record,
                   llvm::ArrayRef<const clang::Expr*> arguments) {
  const auto message = message_of_class(record);
  if (!message || arguments.size() < 3) return;
  auto site = site_at<Advertise>(unit, expr, *message, codes::TZC1021,
                                 "'" + qualified_name_of(record) + "' advertises it");
  site.topic = constant_string(arguments[1]);
  unit.facts.advertises.emplace(id_of(site.where, site.type), site);
}

}  // namespace

void collect_library_construction(Unit& unit, const clang::CXXConstructExpr* construct) {
  const clang::CXXRecordDecl* record = construct->getConstructor()->getParent();
  const PublishingClass* known = publishing_class(record);
  if (known && known->advertise)
    add_advertise(unit, construct, record,
                  llvm::ArrayRef<const clang::Expr*>(construct->getArgs(), construct->getNumArgs()));
}

void collect_library_member_call(Unit& unit, const clang::CXXMemberCallExpr* call) {
  const clang::CXXRecordDecl* record = call->getMethodDecl()->getParent();
  const PublishingClass* known = publishing_class(record);
  if (!known) return;
  const std::string name = call->getMethodDecl()->getNameAsString();
  if (known->advertise && name == known->advertise)
    add_advertise(unit, call, record,
                  llvm::ArrayRef<const clang::Expr*>(call->getArgs(), call->getNumArgs()));
  const auto message = message_of_class(record);
  if (!message || name != known->publish) return;
  const auto site = site_at<Publish>(unit, call, *message, codes::TZC1021,
                                     "'" + qualified_name_of(record) + "' publishes it");
  unit.facts.publishes.emplace(id_of(site.where, site.type), site);
}

void collect_wait_for_message(Unit& unit, const clang::CallExpr* call) {
  const clang::FunctionDecl* function = call->getDirectCallee();
  if (!function || qualified_name_of(function) != "ros::topic::waitForMessage") return;
  const auto message = first_message(function->getTemplateSpecializationArgs());
  if (!message) return;
  auto site = site_at<Subscribe>(unit, call, *message, codes::TZC2008,
                                 "the call subscribes inside roscpp for one message");
  if (call->getNumArgs() > 0) site.topic = constant_string(call->getArg(0));
  unit.facts.subscribes.emplace(id_of(site.where, site.type), site);
}

}  // namespace tzc::rewriter
