// SPDX-License-Identifier: BSD-3-Clause
#include "recorder/xmlrpc.h"

#include <ros/network.h>
#include <ros/this_node.h>

#include <chrono>

namespace tzc::compare {
namespace {

using XmlRpc::XmlRpcValue;
using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds timeout{500};

/// The value of a reply [code, status, value]. roscpp's getBusStats replies with the value alone.
std::optional<XmlRpcValue> value_of(XmlRpcValue& reply) {
  if (reply.size() == 0 || reply[0].getType() != XmlRpcValue::TypeInt) return reply;
  if (reply.size() != 3 || static_cast<int>(reply[0]) != 1) return std::nullopt;
  return reply[2];
}

std::optional<XmlRpcValue> call(const std::string& uri, const char* method, const XmlRpcValue& arguments) {
  std::string host;
  std::uint32_t port = 0;
  if (!ros::network::splitURI(uri, host, port)) return std::nullopt;
  XmlRpc::XmlRpcClient client(host.c_str(), static_cast<int>(port), "/");
  if (!client.executeNonBlock(method, arguments)) return std::nullopt;
  XmlRpcValue result;
  const Clock::time_point deadline = Clock::now() + timeout;
  while (!client.executeCheckDone(result)) {
    if (client.getfd() < 0 || Clock::now() > deadline) return std::nullopt;
    client._disp.work(0.02);
  }
  if (!result.valid() || client.isFault() || result.getType() != XmlRpcValue::TypeArray) return std::nullopt;
  return value_of(result);
}

}  // namespace

std::optional<XmlRpcValue> call(const std::string& uri, const char* method) {
  XmlRpcValue arguments;
  arguments[0] = ros::this_node::getName();
  return call(uri, method, arguments);
}

std::optional<XmlRpcValue> call(const std::string& uri, const char* method, const std::string& argument) {
  XmlRpcValue arguments;
  arguments[0] = ros::this_node::getName();
  arguments[1] = argument;
  return call(uri, method, arguments);
}

}  // namespace tzc::compare
