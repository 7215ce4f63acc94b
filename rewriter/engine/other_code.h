// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <set>
#include <string>

#include "engine/options.h"
#include "solve/port_edits.h"
#include "verify/unseen_uses.h"

namespace tzc::rewriter {

/// What has to stay because of code that is not analysed, which no parse would show.
class OtherCodeLimits {
 public:
  /// `exported`: headers, or folders of headers, that other packages may include. The arguments must outlive the object.
  OtherCodeLimits(const OtherCode& others, const std::set<std::string>& exported, const UnseenUses& unseen)
      : others_(others), exported_(exported), unseen_(unseen) {}

  /// The components that the plan must not change.
  std::map<ComponentId, Obstacle> broken_by(const PortEdits& plan) const;

 private:
  void add_copied(const PortEdits& plan, std::map<ComponentId, Obstacle>& found) const;
  void add_unshared(const PortEdits& plan, std::map<ComponentId, Obstacle>& found) const;
  std::string unshared_in(const std::set<std::string>& headers) const;
  bool is_exported(const std::string& file) const;

  const OtherCode& others_;
  const std::set<std::string>& exported_;
  const UnseenUses& unseen_;
};

}  // namespace tzc::rewriter
