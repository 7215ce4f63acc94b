// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <set>
#include <string>
#include <vector>

#include "engine/comparison.h"

namespace tzc::compare {

enum class Cause { not_published, new_topic, type, loss, extra, order, content };

/// One difference between the port and the original on one topic, or between two runs of the original.
struct Finding {
  Cause cause;
  std::string field;      ///< of Cause::content
  std::size_t count = 0;  ///< messages
  std::size_t total = 0;  ///< of so many
  double own_share = 0;  ///< share of messages in which the original's runs differ like that among themselves
  bool is_different = true;  ///< false: the original's own runs differ like that, too
  std::string detail;        ///< the first difference, or how many of the extra messages are repetitions
};

enum class Outcome {
  equal,
  own_differences,  ///< equal, but for what the original's own runs do not repeat either
  silent,           ///< nothing was published in either run
  different
};

struct StreamVerdict {
  StreamComparison comparison;
  Outcome outcome = Outcome::equal;
  std::vector<Finding> findings;
};

struct Rules {
  std::set<std::string> late_topics;  ///< whose first messages do not count in any case
  bool judge_before = false;          ///< messages before the other recording's first one count as lost
  bool judge_after = false;           ///< messages after its last one do
  double allowed_loss = 0;            ///< share of messages that may be lost or extra
  bool strict = false;  ///< what the original does not repeat, other than header stamps, is a difference
};

/// Judges a port, stream by stream, by how the original differs from itself. What the original always repeats
/// must be the same in the port. A difference that x % of its own messages have may occur in 2x % + 5 % of
/// the port's. Where the end of a recording is not judged, a port that has fallen silent has lost messages
/// all the same: nothing came for more than twice as long as in the original's runs, and two seconds.
/// @param own comparisons of the original's first run with its other runs
/// @param port comparison of the original's first run with the port's
std::vector<StreamVerdict> judge(const std::vector<Comparison>& own, Comparison port, const Rules& rules);

bool is_different(const std::vector<StreamVerdict>& verdicts);

const char* name(Cause cause);
const char* name(Outcome outcome);

}  // namespace tzc::compare
