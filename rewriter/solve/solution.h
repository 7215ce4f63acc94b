// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "engine.h"
#include "facts/facts.h"
#include "solve/components.h"

namespace tzc::rewriter {

/// Components that must not be ported after all, and why.
using Demotions = std::map<std::string, Obstacle>;

/// What is ported, how far, and why not further.
struct Solution {
  struct Publisher {
    bool ported = false;
    Obstacle why_not;
    Key at;  ///< the entity that has the obstacle
  };
  struct Message {
    bool ported = false;
    bool empty = false;  ///< no array of it is ever filled
    Obstacle why_not;
    Key at;
  };
  struct Bound {
    const Birth* birth;
    std::string publisher;           ///< expression: "pub_", "*pub"
    std::string call;                ///< "pub_.allocate"
    const Entity* entity = nullptr;  ///< none: the helper's own parameter
  };
  /// A helper that is given the publisher.
  struct GivenPublisher {
    std::string helper;  ///< USR
    Key message;         ///< that it builds
    std::string type;    ///< "tzc::Publisher"
    std::string header;
  };

  std::map<int, Publisher> publishers;  ///< by component
  std::map<int, Message> messages;
  std::map<int, Publisher> filters;
  std::vector<Bound> births;
  std::vector<GivenPublisher> helpers;
  std::vector<Site> sites;
  std::set<std::string> subscribes;  ///< that are ported, by their id in the facts
};

/// Decides for each component. Subscribe sites that are demoted are named "subscribe " + their id in the
/// facts.
Solution solve(const Facts& facts, const Components& components, const EngineOptions& options,
               const Demotions& demotions);

}  // namespace tzc::rewriter
