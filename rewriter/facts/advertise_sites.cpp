// SPDX-License-Identifier: BSD-3-Clause
#include "facts/advertise_sites.h"

#include "facts/ast_walk.h"
#include "facts/calls.h"
#include "facts/library_advertise.h"
#include "model/codes.h"

namespace tzc::rewriter {
namespace {

/// What is advertised: advertise<M>(...), or the options' type.
clang::QualType advertised_type(const Unit& unit, const clang::CXXMemberCallExpr* call) {
  const clang::CXXMethodDecl* method = call->getMethodDecl();
  if (!method->getTemplateSpecializationArgs() && written_arguments(call) == 1)
    return options_message(unit, call->getArg(0)).value_or(clang::QualType());
  const clang::TemplateArgumentList* arguments = method->getTemplateSpecializationArgs();
  if (!arguments || arguments->size() == 0 || (*arguments)[0].getKind() != clang::TemplateArgument::Type)
    return {};
  return (*arguments)[0].getAsType();
}

std::optional<Place> behind_argument(const Unit& unit, const clang::CallExpr* call, unsigned index) {
  if (written_arguments(call) <= index) return {};
  std::optional<Place> place = unit.source.place(call->getArg(index)->getSourceRange());
  if (place) place->begin = place->end;
  return place;
}

bool takes_template_parameter(const clang::CXXMemberCallExpr* call) {
  const auto* callee = llvm::dyn_cast<clang::MemberExpr>(call->getCallee()->IgnoreParens());
  return callee && callee->getNumTemplateArgs() != 0 &&
         is_template_parameter(callee->getTemplateArgs()[0].getArgument());
}

}  // namespace

/// An image unless the call names another type.
Advertise AdvertiseCollector::site_at(const clang::CallExpr* call, const char* rule) const {
  Advertise site;
  site.where = unit_.source.where(call->getExprLoc());
  site.function = enclosing_function_name(unit_.ast(), *call);
  site.rule = rule;
  site.type = "sensor_msgs/Image";
  return site;
}

void AdvertiseCollector::describe_type(Advertise& site, clang::QualType type) const {
  const std::optional<MessageType> twin = twin_message_of(type);
  if (const auto message = twin ? twin : message_of(type)) {
    site.type = message->name;
    site.has_data_part = message->has_data_part;
    site.no_twin = !message->has_data_part || message->service || !unit_.has_twin(site.type);
  } else if (is_pcl_cloud(type)) {
    site.type = "sensor_msgs/PointCloud2";
    site.no_twin = site.pcl = true;
  } else {
    site.type = type.getAsString();
    site.no_twin = true;
    site.has_data_part = false;
  }
}

void AdvertiseCollector::change(Advertise& site, const clang::CXXMemberCallExpr* call,
                                const MethodCall& rule) const {
  std::string to = rule.to;
  if (rule.role == MethodCall::Role::advertise) {
    const std::string written = written_template_arguments(unit_, call);
    const std::string stock = written.empty() ? stock_name(site.type) : written;
    const bool as_written = site.no_twin || takes_template_parameter(call);
    to += "<" + (as_written ? stock : twin_name(site.type)) + ">";
  }
  site.changes = receiver_first(unit_, call, {to, rule.rule, rule.header});
  if (site.changes.empty()) {
    site.obstacles.push_back(
        {codes::TZC1006, "the advertise call comes from a macro", location_of(site.where)});
    return;
  }
  if (!site.no_twin && rule.role == MethodCall::Role::advertise)
    site.changes[0].headers.push_back(twin_header(site.type));
  const clang::QualType type = advertised_type(unit_, call);
  if (!type.isNull() && is_pcl_cloud(type)) site.changes[0].headers.push_back("tzc/pcl.h");
  if (rule.role == MethodCall::Role::advertise) add_memory(site, call, rule);
}

void AdvertiseCollector::add_memory(Advertise& site, const clang::CXXMemberCallExpr* call,
                                    const MethodCall& rule) const {
  const unsigned last = written_arguments(call) == 1 ? 0 : 1;
  if (const auto memory = behind_argument(unit_, call, last))
    site.changes.push_back({*memory, ", $MEM", rule.rule, {}});
  else
    site.obstacles.push_back({codes::TZC1006, "an argument comes from a macro", location_of(site.where)});
}

Advertise AdvertiseCollector::of_call(const clang::CXXMemberCallExpr* call, const MethodCall& rule) {
  Advertise site = site_at(call, rule.rule);
  if (rule.role == MethodCall::Role::advertise) {
    const clang::QualType type = advertised_type(unit_, call);
    if (!type.isNull())
      describe_type(site, type);
    else
      site.obstacles.push_back(
          {codes::TZC1012, "the options of this call say what is advertised", location_of(site.where)});
  }
  if (written_arguments(call) > 0) site.topic = constant_string(call->getArg(0));
  site.queue = written_text(unit_, call, 1);
  site.publisher = entities_.declare_temporary(call);
  change(site, call, rule);
  for (const Obstacle& obstacle : site.obstacles) entities_.add_obstacle(site.publisher, obstacle);
  return site;
}

Advertise AdvertiseCollector::of_ported_call(const clang::CallExpr* call, const MethodCall& rule) {
  Advertise site = site_at(call, rule.rule);
  const clang::TemplateArgumentList* arguments = call->getDirectCallee()->getTemplateSpecializationArgs();
  if (rule.role == MethodCall::Role::advertise && arguments) describe_type(site, (*arguments)[0].getAsType());
  if (written_arguments(call) > 1) site.topic = constant_string(call->getArg(1));
  site.memory =
      rule.role == MethodCall::Role::advertise ? written_text(unit_, call, site.topic ? 3 : 2) : "0";
  site.publisher = entities_.declare_temporary(call);
  return site;
}

void AdvertiseCollector::describe_topic(Advertise& site, const clang::CallExpr* call) const {
  for (unsigned i = 0; i < written_arguments(call) && !site.topic; ++i) {
    site.topic = constant_string(call->getArg(i));
    if (site.topic) site.queue = written_text(unit_, call, i + 1);
  }
}

std::string AdvertiseCollector::attach_text(const Advertise& site, const clang::CallExpr* call,
                                            const LibraryAdvertise& rule) const {
  if (!rule.is_template) return std::string(rule.to) + "(";
  const clang::TemplateArgumentLoc& written = written_arguments_of(call)[0];
  const bool as_written = site.no_twin || is_template_parameter(written.getArgument());
  const std::string type = as_written ? unit_.source.text(written.getSourceRange()) : twin_name(site.type);
  return std::string(rule.to) + "<" + type + ">(";
}

void AdvertiseCollector::attach(Advertise& site, const clang::CallExpr* call, const LibraryAdvertise& rule) {
  const std::optional<Place> whole = unit_.source.place(call->getSourceRange());
  if (!whole) {
    const Obstacle obstacle{codes::TZC1006, "the advertise call comes from a macro", location_of(site.where)};
    site.obstacles.push_back(obstacle);
    entities_.add_obstacle(site.publisher, obstacle);
    return;
  }
  Place begin = *whole, end = *whole;
  begin.end = begin.begin;
  end.begin = end.end;
  site.changes = {{begin, attach_text(site, call, rule), rule.rule, {rule.header}},
                  {end, rule.is_template ? ", $MEM)" : ")", rule.rule, {}}};
  if (rule.is_template && !site.no_twin) site.changes[0].headers.push_back(twin_header(site.type));
  if (site.pcl) site.changes[0].headers.push_back("tzc/pcl.h");
}

std::optional<AdvertiseCollector::LibraryCall> AdvertiseCollector::of_library_call(
    const clang::CallExpr* call) {
  const LibraryAdvertise* rule = library_advertise_rule(unit_, call);
  if (!rule) return {};
  Advertise site = site_at(call, rule->rule);
  if (rule->is_template) describe_type(site, library_advertised_type(call));
  describe_topic(site, call);
  const clang::CallExpr* ported = attaching_call(unit_, call, *rule);
  const clang::CallExpr* publisher = ported ? ported : call;
  site.publisher = entities_.declare_temporary(publisher);
  if (ported)
    site.memory = rule->is_template ? written_text(unit_, ported, 1) : "0";
  else
    attach(site, call, *rule);
  return LibraryCall{std::move(site), publisher};
}

}  // namespace tzc::rewriter
