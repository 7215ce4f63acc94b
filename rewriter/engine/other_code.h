// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "engine/options.h"
#include "model/facts.h"
#include "model/location.h"
#include "solve/port_edits.h"
#include "verify/unseen_uses.h"

namespace tzc::rewriter {

/// Says of the types that are subscribed to where other packages may cast the const of a received message away.
void add_casts_elsewhere(Facts& facts, const OtherCode& others);

/// What has to stay because of code that is not analysed, and texts that macros make of code: no parse of the port would show
/// what becomes of them.
class OtherCodeLimits {
 public:
  /// `exported`: headers, or folders of headers, that other packages may include. `texts`: arguments that a macro makes a text of.
  /// The arguments must outlive the object.
  OtherCodeLimits(const OtherCode& others, const std::set<std::string>& exported, const UnseenUses& unseen,
                  const std::vector<Place>& texts)
      : others_(others), exported_(exported), unseen_(unseen), texts_(texts) {}

  /// The components that the plan must not change.
  std::map<ComponentId, Obstacle> broken_by(const PortEdits& plan) const;

 private:
  void add_copied(const PortEdits& plan, std::map<ComponentId, Obstacle>& found) const;
  void add_texts(const PortEdits& plan, std::map<ComponentId, Obstacle>& found) const;
  void add_unshared(const PortEdits& plan, std::map<ComponentId, Obstacle>& found) const;
  std::string unshared_in(const std::set<std::string>& headers) const;
  bool is_exported(const std::string& file) const;

  const OtherCode& others_;
  const std::set<std::string>& exported_;
  const UnseenUses& unseen_;
  const std::vector<Place>& texts_;
};

}  // namespace tzc::rewriter
