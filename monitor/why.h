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

/// A subscription of which only the subscriber's own page tells: its publisher's page, if there is one, does not have the topic.
struct OneSided {
  const Node* node;
  const Subscription* subscription;
};

/// Those of the nodes, to which it points.
std::vector<OneSided> one_sided(const std::vector<Node>& nodes);
/// How it gets its messages; where that is not through shared memory, also why, as far as the pages of `nodes` tell.
std::string sentence_of(const OneSided& one, const std::vector<Node>& nodes);

/// Why the connections of a node on a topic, as its publisher or subscriber, are shared or not.
Explanation explain(const std::vector<Node>& nodes, const std::string& node, const std::string& topic);

}  // namespace tzc::monitor
