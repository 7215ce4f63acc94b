// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "model.h"

namespace tzc::monitor {

/// A ROS name as pages have it: from the root.
inline std::string global_name(const std::string& name) {
  return name.empty() || name[0] == '/' ? name : "/" + name;
}

/// Keeps one topic, and the nodes that publish it, with TZC or by roscpp alone, or subscribe to it. An empty name keeps all.
void keep_topic(const std::string& topic, std::vector<Node>& nodes);

}  // namespace tzc::monitor
