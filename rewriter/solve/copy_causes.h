// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <optional>

#include "model/content_flow.h"
#include "model/obstacle.h"
#include "solve/content_state.h"

namespace tzc::rewriter {

/// Why the elements that are published in a place are copied: they lay outside shared memory, somebody writes to them later, or needs more of
/// them. The first cause that was found of each kind.
class CopyCauses {
 public:
  void taken(const PublishPlace& site, const Taken& taken) { taken_.emplace(site, taken); }
  void written(const PublishPlace& site, const Location& where) { writes_.emplace(site, where); }
  void grown(const PublishPlace& site, const Location& where) { grows_.emplace(site, where); }

  /// None: nothing copies them.
  std::optional<Obstacle> why(const PublishPlace& site) const;

 private:
  std::map<PublishPlace, Taken> taken_;
  std::map<PublishPlace, Location> writes_, grows_;
};

}  // namespace tzc::rewriter
