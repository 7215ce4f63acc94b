// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <xmlrpcpp/XmlRpc.h>

#include <optional>
#include <string>

namespace tzc::compare {

/// Calls a method of the slave API (or the master's) with the recorder's name as its argument, and waits for
/// half a second at most: a node that is stopped must not stop the recorder. Null without a success in ROS's
/// form.
std::optional<XmlRpc::XmlRpcValue> call(const std::string& uri, const char* method);
/// The same with one more argument.
std::optional<XmlRpc::XmlRpcValue> call(const std::string& uri, const char* method,
                                        const std::string& argument);

}  // namespace tzc::compare
