// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "buildfiles/compile_database.h"
#include "proof/cmake_targets.h"

namespace tzc::rewriter {

struct Lack {
  std::string what, hint;  ///< as an Error has them
};

/// What a command lacks to compile a ported unit; none: it lacks nothing.
std::optional<Lack> lacks_for_tzc(const CompileCommand& command);

/// A target that links the objects of `target` without TZC's libraries; none: there is none.
const CmakeTarget* linked_without_tzc(const std::vector<CmakeTarget>& all, const std::string& target);

}  // namespace tzc::rewriter
