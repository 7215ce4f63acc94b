// SPDX-License-Identifier: BSD-3-Clause
#include "facts/sites/subscribe_sites.h"

#include "facts/sites/argument_order.h"
#include "facts/sites/asked_transport.h"
#include "facts/sites/callback_functions.h"
#include "facts/sites/callback_parameter.h"
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

}  // namespace

/// The parameters of the functions that the call is given.
void SubscribeCollector::add_callbacks(Subscribe& site, const clang::CallExpr* call) {
  site.is_unknown = site.is_unknown || calls_unknown_functions(unit_, call);
  for (const clang::FunctionDecl* function : callback_functions(unit_, call))
    for (const clang::ParmVarDecl* parameter : function->parameters())
      if (const EntityId id = entities_.declare(parameter); !id.empty()) site.callbacks.push_back(id);
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
    if (const auto type = options_message(unit_, call->getArg(0))) {
      parameter.message = message_of(*type);
      written = stock_name(parameter.message->name);
    }
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
