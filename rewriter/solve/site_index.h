// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <vector>

#include "model/facts.h"
#include "solve/components.h"

namespace tzc::rewriter {

/// The sites of each component, in the order of the facts, which must outlive it.
class SiteIndex {
 public:
  template <class Fact>
  using Sites = std::vector<const Fact*>;

  SiteIndex(const Facts& facts, const Components& components);

  const Sites<Publish>& published_by(const Component& publisher) const;
  const Sites<Publish>& publishes_of(const Component& message) const;
  const Sites<Advertise>& advertised(const Component& publisher) const;
  const Sites<AllocationSite>& allocations(const Component& message) const;

 private:
  template <class Fact>
  using ByComponent = std::map<ComponentId, Sites<Fact>>;
  template <class Fact>
  static const Sites<Fact>& at(const ByComponent<Fact>& sites, const Component& component);

  ByComponent<Publish> published_by_, publishes_of_;
  ByComponent<Advertise> advertised_;
  ByComponent<AllocationSite> allocations_;
};

}  // namespace tzc::rewriter
