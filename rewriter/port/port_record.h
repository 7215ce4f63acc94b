// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "port/package_port.h"

namespace tzc::rewriter {

/// What the cache keeps of a run: its result, and the state of each place that it depends on.
struct PortRecord {
  std::map<FileAccesses::Entry, std::string> places;
  std::vector<PackagePort> ports;  ///< without the snapshot that only writing needs
};

std::string encoded(const PortRecord& record);

/// None: it is not what encoded() makes.
std::optional<PortRecord> decoded(const std::string& bytes);

}  // namespace tzc::rewriter
