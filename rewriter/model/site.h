// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "model/level.h"
#include "model/location.h"

namespace tzc::rewriter {

enum class SiteKind { advertise, publish, subscribe };

/// One step of the flow that led to a level, the site first: "stored in member `image_`", "passed to
/// `rotate()`", ...
struct FlowStep {
  Location where;
  std::string what;
};

/// A place where the package advertises, publishes or subscribes to a data-heavy type.
struct Site {
  /// Stable over edits elsewhere: kind + relative file + enclosing function + ordinal (+ type of a template).
  std::string id;
  SiteKind kind = SiteKind::publish;
  Location where;
  std::string message_type;          ///< "sensor_msgs/Image"
  std::optional<std::string> topic;  ///< none: not a constant
  Level level = Level::plain;
  std::string code;    ///< TZCnnnn; empty: ported without remark
  std::string reason;  ///< one sentence: what was seen; without a code: what the level rests on
  std::vector<FlowStep> flow_path;
  std::string rule;                   ///< the rule that ported it
  bool suppressed = false;            ///< by a tzc-ignore comment; set by the tool, not by the engine
  std::string suppression_reason;     ///< what that comment says
  std::string memory_note;            ///< how the memory size was chosen
  bool in_exported_header = false;    ///< what refused it; --exported-headers=change may take that away
  bool pending = false;               ///< the port has edits for it; false as well where it is ported already
  std::vector<unsigned> in_macros{};  ///< as a SiteId's; not kept with the results of earlier runs
};

/// Whether the user wants this site ported (--only, --except). Called with id, kind, where, message_type and
/// topic set.
using SiteFilter = std::function<bool(const Site&)>;

}  // namespace tzc::rewriter
