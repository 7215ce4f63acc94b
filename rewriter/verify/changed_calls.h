// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "verify/callees.h"

namespace tzc::rewriter {

/// The original behind the calls of an edited unit.
struct OriginalUnit {
  const std::vector<PackageCall>& calls;
  std::function<bool(const std::string& file)> has;  ///< whether the unit included the file
  /// Whether a line of an edited file stands for this line of the original.
  std::function<bool(const std::string& file, unsigned edited_line, unsigned line)> is_line;
  /// Whether an edit wrote a function of TZC in place of this call's.
  std::function<bool(const PackageCall&)> is_replaced;
};

/// The first call of an edited unit that picks another function than the original's does, or that the original has and the
/// edited unit has not; none: all pick what they did.
///
/// Calls are compared file by file, since an edit may include a header of the package earlier than before. A file that the
/// unit did not include picked nothing before. An instantiation is compared with that of the same arguments, where a
/// message and its tzc:: twin count as the same; one that has no such counterpart, with all of its template. Arguments
/// do not tell where a closure stands (`Instances`), so a unit whose lines have moved, and nothing else, has no changed call.
std::optional<PackageCall> changed_call(const OriginalUnit& original, const std::vector<PackageCall>& now);

/// What a changed call picks, or picked: 'api::touch', lambda in 'main'.
std::string picked_by(const PackageCall& call);

}  // namespace tzc::rewriter
