// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "buildfiles/compile_database.h"
#include "model/expected.h"
#include "proof/configuration.h"
#include "proof/ported_package.h"

namespace tzc::rewriter {

/// Whether what a command compiles finds TZC's headers once its package is configured again, though none of its folders has them now.
using GetsTzc = std::function<bool(const CompileCommand&)>;

/// Why other packages, which have build trees of their own, could not be compiled any more; none: they can. `users`: commands that
/// seem to compile or include what is changed.
std::optional<Error> outdated_user(const PortedPackage& package, const std::vector<CompileCommand>& users,
                                   const GetsTzc& gets_tzc);

/// The reasons why packages cannot be written, by folder. A package is proved when the scratch workspace can
/// be configured with it, and when every command that compiles one of its units then finds TZC's headers, those that the build makes
/// included, asks for C++14 or later, and ends in a link with TZC's libraries; and when what it compiled as C++98 or C++03 without touching
/// TZC compiles as C++14, where its build files ask for that now. All packages belong to one build tree.
std::map<std::string, Error> unproved_packages(const UserBuild& user,
                                               const std::vector<PortedPackage>& packages,
                                               const ProofOptions& options);

}  // namespace tzc::rewriter
