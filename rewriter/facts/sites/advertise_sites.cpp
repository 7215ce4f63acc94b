// SPDX-License-Identifier: BSD-3-Clause
#include "facts/sites/advertise_sites.h"

#include "facts/sites/argument_order.h"
#include "facts/sites/attached_advertise.h"
#include "facts/syntax/ast_walk.h"
#include "facts/syntax/call_place.h"
#include "facts/syntax/calls.h"
#include "facts/syntax/library_advertise.h"
#include "facts/syntax/number_values.h"
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
  std::optional<Place> place = argument_place(unit, call, index);
  if (place) place->begin = place->end;
  return place;
}

/// The queue size: its number, also of a macro or a constant, where the compiler knows it; else as it is written.
std::optional<std::string> queue_size(const Unit& unit, const clang::CallExpr* call, unsigned index) {
  if (written_arguments(call) <= index) return {};
  const std::optional<std::string> number = constant_integer(unit, call->getArg(index));
  return number ? number : unit.text(call->getArg(index));
}

/// Whether an argument that follows the queue size is told from a memory size: a bool, or a callback that is no 0.
bool is_no_size(const clang::CXXMemberCallExpr* call, unsigned index) {
  const clang::QualType written = call->getArg(index)->IgnoreUnlessSpelledInSource()->getType();
  const clang::QualType wanted = call->getMethodDecl()->getParamDecl(index)->getType();
  return wanted->isBooleanType() ? written->isBooleanType() : !written->isArithmeticType();
}

/// The memory size of tzc::advertise<M>(nh, topic, queue, memory, ...) or tzc::advertise<M>(nh, options, memory).
std::string written_memory(const Unit& unit, const clang::CallExpr* call) {
  if (written_arguments(call) < 3) return "0";
  const bool by_options = call->getArg(1)->getType()->isRecordType() &&
                          call->getArg(1)->getType()->getAsCXXRecordDecl()->getName() == "AdvertiseOptions";
  const unsigned index = by_options ? 2 : 3;
  const std::optional<std::string> text = written_text(unit, call, index);
  if (!text) return "0";
  const clang::QualType type = call->getArg(index)->IgnoreUnlessSpelledInSource()->getType();
  return type->isIntegerType() && !type->isBooleanType() ? *text : "0";
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
  set_place(site, unit_, call);
  site.rule = rule;
  site.type = "sensor_msgs/Image";
  const clang::FunctionDecl* function = enclosing_function(unit_.ast(), *call);
  if (is_instance(function)) site.around = Advertise::Around::template_instance;
  if (function && advertises_for_callers(unit_, function))
    site.around = Advertise::Around::function_for_callers;
  return site;
}

void AdvertiseCollector::describe_type(Advertise& site, clang::QualType type) const {
  const std::optional<MessageType> twin = twin_message_of(type);
  if (const auto message = twin ? twin : message_of(type)) {
    set_message(site, *message);
    site.written.no_twin = !message->has_data_part || message->service || !unit_.has_twin(site.type);
  } else if (is_pcl_cloud(type)) {
    site.type = "sensor_msgs/PointCloud2";
    site.written.no_twin = site.pcl = true;
  } else {
    site.type = type.getAsString();
    site.written.no_twin = true;
    site.has_data_part = false;
  }
}

void AdvertiseCollector::change(Advertise& site, const clang::CXXMemberCallExpr* call,
                                const MethodCall& rule) const {
  std::string to = rule.to;
  if (rule.role == MethodCall::Role::advertise) {
    const std::string written = written_template_arguments(unit_, call);
    site.written.stock = written.empty() ? stock_name(site.type) : written;
    const bool as_written =
        site.written.no_twin || takes_template_parameter(call) || is_type_by_macro(unit_, call);
    site.written.twin = as_written ? site.written.stock : twin_name(site.type);
    to += "<$TYPE>";
  }
  site.changes = receiver_first(unit_, call, {to, rule.rule, rule.header});
  if (site.changes.empty()) {
    site.obstacles.push_back(
        {codes::TZC1006, macro_reason(unit_, call, "the advertise call"), location_of(site.where)});
    return;
  }
  if (order_matters(unit_, call))
    site.obstacles.push_back({codes::TZC1023, "evaluating the node handle may change what the arguments read",
                              location_of(site.where)});
  const clang::QualType type = advertised_type(unit_, call);
  if (!type.isNull() && is_pcl_cloud(type)) site.changes[0].headers.push_back("tzc/pcl.h");
  if (rule.role == MethodCall::Role::advertise) add_memory(site, call, rule);
}

void AdvertiseCollector::add_memory(Advertise& site, const clang::CXXMemberCallExpr* call,
                                    const MethodCall& rule) const {
  const unsigned last = written_arguments(call) == 1 ? 0 : 1;
  site.needs_memory = written_arguments(call) > last + 1 && !is_no_size(call, last + 1);
  if (const auto memory = behind_argument(unit_, call, last))
    site.changes.push_back({*memory, "$MEM", rule.rule, {}});
  else
    site.obstacles.push_back(
        {codes::TZC1006, macro_reason(unit_, call, "the advertise call"), location_of(site.where)});
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
  site.queue = queue_size(unit_, call, 1);
  site.publisher = entities_.declare_temporary(call);
  change(site, call, rule);
  describe_keeping(site, unit_, call);
  for (const Obstacle& obstacle : site.obstacles) entities_.add_obstacle(site.publisher, obstacle);
  return site;
}

Advertise AdvertiseCollector::of_ported_call(const clang::CallExpr* call, const MethodCall& rule) {
  Advertise site = site_at(call, rule.rule);
  const clang::TemplateArgumentList* arguments = call->getDirectCallee()->getTemplateSpecializationArgs();
  if (rule.role == MethodCall::Role::advertise && arguments) describe_type(site, (*arguments)[0].getAsType());
  if (written_arguments(call) > 1) site.topic = constant_string(call->getArg(1));
  site.memory = rule.role == MethodCall::Role::advertise ? written_memory(unit_, call) : "0";
  site.publisher = entities_.declare_temporary(call);
  return site;
}

void AdvertiseCollector::describe_topic(Advertise& site, const clang::CallExpr* call) const {
  for (unsigned i = 0; i < written_arguments(call) && !site.topic; ++i) {
    site.topic = constant_string(call->getArg(i));
    if (site.topic) site.queue = queue_size(unit_, call, i + 1);
  }
}

std::string AdvertiseCollector::attach_text(Advertise& site, const clang::CallExpr* call,
                                            const LibraryAdvertise& rule) const {
  if (!rule.is_template) return std::string(rule.to) + "(";
  const clang::TemplateArgumentLoc& written = written_arguments_of(call)[0];
  site.written.stock = unit_.source.text(written.getSourceRange());
  const bool as_written = site.written.no_twin || is_template_parameter(written.getArgument());
  site.written.twin = as_written ? site.written.stock : twin_name(site.type);
  return std::string(rule.to) + "<$TYPE>(";
}

void AdvertiseCollector::attach(Advertise& site, const clang::CallExpr* call, const LibraryAdvertise& rule) {
  Change before{{}, attach_text(site, call, rule), rule.rule, {rule.header}};
  if (site.pcl) before.headers.push_back("tzc/pcl.h");
  site.changes = put_around(unit_, call, before, rule.is_template ? "$MEM)" : ")");
  if (site.changes.empty()) {
    const Obstacle obstacle{codes::TZC1006, "the advertise call comes from a macro", location_of(site.where)};
    site.obstacles.push_back(obstacle);
    entities_.add_obstacle(site.publisher, obstacle);
    return;
  }
}

std::optional<AdvertiseCollector::LibraryCall> AdvertiseCollector::of_library_call(
    const clang::CallExpr* call) {
  const LibraryAdvertise* rule = library_advertise_rule(unit_, call);
  if (!rule) return {};
  Advertise site = site_at(call, rule->rule);
  if (rule->is_template) describe_type(site, library_advertised_type(call));
  describe_topic(site, call);
  const clang::CallExpr* ported = attaching_call(unit_, call, rule->to);
  const clang::CallExpr* publisher = ported ? ported : call;
  site.publisher = entities_.declare_temporary(publisher);
  if (ported) {
    site.memory = rule->is_template ? written_text(unit_, ported, 1).value_or("0") : "0";
  } else {
    attach(site, call, *rule);
    describe_keeping(site, unit_, call);
  }
  return LibraryCall{std::move(site), publisher};
}

}  // namespace tzc::rewriter
