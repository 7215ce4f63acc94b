// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "model.h"

namespace tzc::monitor {

struct Explanation {
  std::vector<std::string> sentences;  ///< one for each connection
  std::string nothing;                 ///< without sentences: what was looked for in vain
};

/// Why the connections of a node on a topic, as its publisher or subscriber, are shared or not.
Explanation explain(const std::vector<Node>& nodes, const std::string& node, const std::string& topic);

}  // namespace tzc::monitor
