// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/upgrade/xmlrpc_call.h"

#include <ros/network.h>
#include <xmlrpcpp/XmlRpcClient.h>

#include "roscpp/before_exit.h"

namespace tzc {
namespace detail {
namespace {

using Clock = std::chrono::steady_clock;

/// Runs the client's own event loop in small steps until the answer arrives. False: the connection has ended,
/// time is up, or the process ends. executeNonBlock has added the client to the loop; adding it twice would make the loop spin.
bool wait_for_answer(XmlRpc::XmlRpcClient& client, XmlRpc::XmlRpcValue& result, Clock::time_point deadline) {
  while (!client.executeCheckDone(result)) {
    if (client.getfd() < 0 || Clock::now() > deadline || exit_has_begun()) return false;
    client._disp.work(0.02);
  }
  return result.valid();  // or else the connection has ended
}

XmlRpcReply no_answer(const std::string& why) {
  XmlRpcReply reply;
  reply.status = why;
  return reply;
}

XmlRpcReply parse(XmlRpc::XmlRpcValue& result) {
  using XmlRpc::XmlRpcValue;
  if (result.getType() != XmlRpcValue::TypeArray || result.size() < 2 ||
      result[0].getType() != XmlRpcValue::TypeInt || result[1].getType() != XmlRpcValue::TypeString)
    return no_answer("the answer is not a ROS response");
  XmlRpcReply reply;
  reply.answered = true;
  reply.code = result[0];
  reply.status = static_cast<std::string>(result[1]);
  if (result.size() > 2) reply.value = result[2];
  return reply;
}

}  // namespace

XmlRpcReply call_node(const std::string& uri, const char* method, const XmlRpc::XmlRpcValue& params,
                      std::chrono::milliseconds timeout) {
  std::string host;
  std::uint32_t port = 0;
  if (!ros::network::splitURI(uri, host, port)) return no_answer("not a node's address: " + uri);
  XmlRpc::XmlRpcClient client(host.c_str(), static_cast<int>(port), "/");
  if (!client.executeNonBlock(method, params)) return no_answer("cannot connect to " + uri);
  XmlRpc::XmlRpcValue result;
  if (!wait_for_answer(client, result, Clock::now() + timeout)) return no_answer("no answer from " + uri);
  if (!client.isFault()) return parse(result);
  XmlRpcReply fault = no_answer("the node at " + uri + " does not know the method " + method);
  fault.unknown = true;
  return fault;
}

}  // namespace detail
}  // namespace tzc
