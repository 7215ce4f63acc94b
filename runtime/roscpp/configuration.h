// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tzc/options.h>

#include <string>

namespace tzc {

/// TZC may be used for this resolved topic in this node. Thread-safe; the first call reads the parameter
/// server.
bool is_enabled(const std::string& topic);

/// What the code asked for, overridden by environment and ROS parameters (docs/configuration.md).
PublisherOptions configured(const PublisherOptions& in_code);

/// How often another node is called for an upgrade before the connection is left on TCPROS.
int most_tries();

}  // namespace tzc
