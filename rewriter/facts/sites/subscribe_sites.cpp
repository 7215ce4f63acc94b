// SPDX-License-Identifier: BSD-3-Clause
#include "facts/sites/subscribe_sites.h"

#include "facts/sites/argument_order.h"
#include "facts/sites/asked_transport.h"
#include "facts/sites/callback_functions.h"
#include "facts/sites/callback_parameter.h"
#include "facts/syntax/ast_walk.h"
#include "facts/syntax/call_place.h"
#include "facts/syntax/calls.h"
#include "model/codes.h"

namespace tzc::rewriter {
namespace {

void describe(Subscribe& site, const CallbackParameter& parameter) {
  if (!parameter.message) return;
  set_message(site, *parameter.message);
  site.writes = parameter.writes;
  site.converts = parameter.converts;
}

/// nh.subscribe(options): which message they are for, and how tzc::subscribe<M>(nh, options) names it. Instances of a template share the
/// call, so it names what the template does.
std::string describe_options(Subscribe& site, CallbackParameter& parameter, const Unit& unit,
                             const clang::CallExpr* call) {
  const clang::Expr* options = call->getArg(0);
  const auto type = options_message(unit, options);
  if (!type) return "";
  parameter.message = message_of(*type);
  const bool is_shared = is_instance(enclosing_function(unit.ast(), *call));
  const std::string name =
      is_shared ? written_options_message(unit, options) : stock_name(parameter.message->name);
  if (name.empty())
    site.obstacles.push_back({codes::TZC1007,
                              "the template does not name the message that its instances' options are for",
                              location_of(site.where)});
  return name;
}

}  // namespace

/// The parameters that receive the message, of the functions that the call is given. A camera's subscription has another one beside it.
void SubscribeCollector::add_callbacks(Subscribe& site, const clang::CallExpr* call) {
  site.is_unknown = site.is_unknown || calls_unknown_functions(unit_, call);
  for (const clang::FunctionDecl* function : callback_functions(unit_, call))
    for (const clang::ParmVarDecl* parameter : function->parameters()) {
      const auto carried = carried_by(parameter->getType(), unit_.rules);
      if (!carried || !carried->message || carried->message->name != site.type) continue;
      if (const EntityId id = entities_.declare(parameter); !id.empty()) site.callbacks.push_back(id);
    }
}

Subscribe SubscribeCollector::site_at(const clang::CallExpr* call, const MethodCall& rule) const {
  Subscribe site;
  set_place(site, unit_, call);
  site.rule = rule.rule;
  site.asked_transport = asked_transport({call->getArgs(), call->getNumArgs()});
  if (rule.role == MethodCall::Role::subscribe_transport) site.type = "sensor_msgs/Image";
  return site;
}

Subscribe SubscribeCollector::of_call(const clang::CXXMemberCallExpr* call, const MethodCall& rule) {
  Subscribe site = site_at(call, rule);
  CallbackParameter parameter = callback_parameter_of(call);
  std::string written = written_template_arguments(unit_, call);
  if (!parameter.message && written_arguments(call) == 1)
    written = describe_options(site, parameter, unit_, call);
  describe(site, parameter);
  add_callbacks(site, call);
  if (written_arguments(call) == 1) add_options(site, call->getArg(0));
  const Location here = location_of(site.where);
  if (site.type.empty())
    site.obstacles.push_back({codes::TZC2006, "no message type is to be seen in this call", here});
  if (written_arguments(call) > 0) site.topic = constant_string(call->getArg(0));
  const std::string to = rule.to + (written.empty() ? "" : "<" + written + ">");
  site.changes = receiver_first(unit_, call, {to, rule.rule, rule.header});
  if (site.converts && !site.changes.empty()) site.changes[0].headers.push_back("tzc/pcl.h");
  if (order_matters(unit_, call))
    site.obstacles.push_back(
        {codes::TZC2011, "evaluating the node handle may change what the arguments read", here});
  if (site.changes.empty())
    site.obstacles.push_back({codes::TZC2003, macro_reason(unit_, call, "the subscribe call"), here});
  return site;
}

/// The callback that ros::SubscribeOptions were given.
void SubscribeCollector::add_options(Subscribe& site, const clang::Expr* options) {
  for (const clang::CallExpr* filled : options_calls(unit_, options)) {
    site.writes = site.writes || callback_parameter_of(filled).writes;
    add_callbacks(site, filled);
  }
}

Subscribe SubscribeCollector::of_ported_call(const clang::CallExpr* call, const MethodCall& rule) {
  Subscribe site = site_at(call, rule);
  site.ported = true;
  describe(site, callback_parameter_of(call));
  add_callbacks(site, call);
  if (written_arguments(call) == 2) add_options(site, call->getArg(1));
  if (written_arguments(call) > 1) site.topic = constant_string(call->getArg(1));
  return site;
}

}  // namespace tzc::rewriter
