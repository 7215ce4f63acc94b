// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <xmlrpcpp/XmlRpc.h>

#include <chrono>
#include <string>

namespace tzc {
namespace detail {

/// The result of a call: a reply in ROS's [code, status, value] form, or the reason why there is none.
struct XmlRpcReply {
  bool answered = false;  ///< the peer replied with a well-formed ROS response
  bool unknown = false;   ///< the peer does not know the method
  int code = 0;           ///< 1: success; other: the peer refused
  std::string status;     ///< the peer's words, or why there was no answer
  XmlRpc::XmlRpcValue value;

  bool succeeded() const { return answered && code == 1; }
};

/// Calls a ROS node's XMLRPC method and waits at most `timeout` (XmlRpcClient alone waits forever). Blocks:
/// for the caller's thread. `uri` is http://host:port/.
XmlRpcReply call_node(const std::string& uri, const char* method, const XmlRpc::XmlRpcValue& params,
                      std::chrono::milliseconds timeout);

}  // namespace detail
}  // namespace tzc
