// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace tzc::rewriter {

enum class SiteKind { advertise, publish, subscribe };

/// How a site is ported. Advertise and publish: zero_copy, one_copy, plain, not_needed; subscribe: shared,
/// copied, plain, not_needed.
enum class Level { zero_copy, one_copy, plain, not_needed, shared, copied };

/// What ported code does when the segment is full.
enum class OnExhausted { deliver, drop, return_from_function };

struct Location {
  std::string file;     ///< absolute, canonical
  unsigned line = 0;    ///< from 1
  unsigned column = 0;  ///< from 1
};

/// One step of the flow that led to a level, the site first: "stored in member `image_`", "passed to
/// `rotate()`", ...
struct FlowStep {
  Location where;
  std::string what;
};

/// A place where the package advertises, publishes or subscribes to a data-heavy type.
struct Site {
  std::string id;  ///< stable over edits elsewhere: kind + relative file + enclosing function + ordinal (+
                   ///< type of a template)
  SiteKind kind = SiteKind::publish;
  Location where;
  std::string message_type;          ///< "sensor_msgs/Image"
  std::optional<std::string> topic;  ///< none: not a constant
  Level level = Level::plain;
  std::string code;    ///< TZCnnnn; empty: ported without remark
  std::string reason;  ///< one sentence: what was seen; empty together with `code`
  std::vector<FlowStep> chain;
  std::string rule;                ///< the rule that ported it
  bool suppressed = false;         ///< by a tzc-ignore comment; set by the tool, not by the engine
  std::string suppression_reason;  ///< what that comment says
  std::string memory_note;         ///< how the memory size was chosen
  int component = -1;              ///< of the flow graph
};

/// A remark that belongs to no site: a file not parsed in this configuration, an #if branch not seen, ...
struct Note {
  std::string code;  ///< TZC3nnn, TZC4nnn
  std::optional<Location> where;
  std::string text;
};

struct Report {
  std::string package;      ///< its name
  std::string package_dir;  ///< absolute, canonical; files are shown relative to it
  std::vector<Site> sites;
  std::vector<Note> notes;
};

/// Whether the user wants this site ported (--only, --except). Called with id, kind, where, message_type and
/// topic set.
using SiteFilter = std::function<bool(const Site&)>;

/// What a long run tells about itself; called from any thread of the engine, one at a time.
class Progress {
 public:
  virtual ~Progress() = default;
  /// `stage` as in "parsing", "verifying"; `done` of `total` units finished, `what` the one that just was.
  virtual void step(const std::string& stage, unsigned done, unsigned total, const std::string& what) = 0;
};

}  // namespace tzc::rewriter
