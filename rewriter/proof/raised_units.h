// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "buildfiles/compile_database.h"
#include "model/expected.h"
#include "proof/paths.h"
#include "proof/ported_package.h"

namespace tzc::rewriter {

/// The commands of a build tree, as the user has it and as it is configured with the port.
struct CommandsOfTree {
  const std::vector<CompileCommand>& before;
  const std::vector<CompileCommand>& ported;
  const PathMap& to_user;  ///< for the files of `ported`
};

/// Why the package cannot have its standard raised: its compiler rejects, as C++14, a unit that was C++98 or C++03 and that
/// the port does not touch, so that nothing else has compiled it; none: it rejects none.
std::optional<Error> rejected_as_cxx14(const PortedPackage& package, const CommandsOfTree& commands,
                                       const ProofOptions& options);

}  // namespace tzc::rewriter
