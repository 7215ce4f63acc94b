// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/runtime.h"

#include <ros/init.h>
#include <ros/xmlrpc_manager.h>

#include <atomic>
#include <memory>

#include "roscpp/publish/publication_endpoint.h"
#include "roscpp/upgrade/offer.h"

namespace tzc {
namespace detail {
namespace {

using XmlRpc::XmlRpcValue;

bool is_request(XmlRpcValue& params) {
  return params.getType() == XmlRpcValue::TypeArray && params.size() == 3 &&
         params[0].getType() == XmlRpcValue::TypeInt && static_cast<int>(params[0]) == kOfferVersion &&
         params[1].getType() == XmlRpcValue::TypeString && params[2].getType() == XmlRpcValue::TypeString;
}

/// Answers a subscriber that requests an offer; XMLRPC thread.
void answer_request(XmlRpcValue& params, XmlRpcValue& result) {
  if (!is_request(params)) {
    result = response(0, "not a request of this version of TZC");
    return;
  }
  const std::string topic = static_cast<std::string>(params[1]);
  const std::string subscriber = static_cast<std::string>(params[2]);
  runtime().requests.note(topic, subscriber);
  result = response(1, "noted");
}

std::atomic<bool> is_bound{false}, is_binding{false};

/// Part of what is bound: roscpp forgets its methods when the node shuts down, also one that starts again (the program's first node handle was a
/// temporary).
struct Binding {
  Binding() { is_bound = true; }
  ~Binding() { is_bound = false; }
};

void bind_methods() {
  is_binding = false;
  if (is_bound) return;
  const auto binding = std::make_shared<Binding>();
  const ros::XMLRPCManagerPtr& xmlrpc = ros::XMLRPCManager::instance();
  xmlrpc->bind(kOfferMethod, [binding](XmlRpcValue& params, XmlRpcValue& result) {
    runtime().responder.answer(params, result);
  });
  xmlrpc->bind(kRequestMethod, answer_request);
}

/// Binding takes microseconds before ROS starts. Afterwards (a nodelet's library) it takes up to half a
/// second, because the XMLRPC thread holds the table while it waits; so another thread does it.
struct BindAtLoad {
  BindAtLoad() {
    if (ros::isStarted())
      runtime().clerk.post(bind_methods);
    else
      bind_methods();
  }
} bind_at_load;

}  // namespace

bool bind_again() {
  if (is_bound) return false;
  if (!is_binding.exchange(true)) runtime().clerk.post(bind_methods);
  return true;
}

Runtime& runtime() {
  static auto* const instance = new Runtime;
  return *instance;
}

}  // namespace detail
}  // namespace tzc
