// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tzc/options.h>

#include <string>

namespace tzc {
namespace detail {

/// Appends a topic's counters as one line of JSON to the file named by the environment variable TZC_STATISTICS; does
/// nothing when it is not set. Called when a topic's last publisher of this process ends.
void append_statistics(const std::string& topic, const PublisherStatistics& statistics);

}  // namespace detail
}  // namespace tzc
