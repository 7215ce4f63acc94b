// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tzc/options.h>

#include <string>

namespace tzc {
namespace detail {

/// Whether TZC may be used for this resolved topic in this node: nothing turns it off, and roscpp is a version that TZC
/// knows. Thread-safe; the first call reads the parameter server.
bool is_enabled(const std::string& topic);

/// Whether this resolved topic alone is turned off in this node (`disable_topics`). Thread-safe.
bool is_left_out(const std::string& topic);

/// Whether the node's settings are known: a thread that may not wait for the parameter server asks this before the others. Thread-safe.
bool are_settings_read();

/// The code's options for a topic, overridden by environment and ROS parameters (docs/configuration.md).
PublisherOptions configured(const PublisherOptions& in_code, const std::string& topic);

/// Whether code of this node may write to messages that it receives (channel::SubscriberOptions::private_writes).
bool private_writes();

/// After how many calls of another node for an upgrade a warning says that the connection is on TCPROS still.
int upgrade_attempts_until_warning();

/// Whether this node keeps a statistics page, which tzc-monitor reads.
bool has_statistics_page();

}  // namespace detail
}  // namespace tzc
