// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "buildfiles/compile_database.h"
#include "model/edit.h"
#include "proof/cmake_targets.h"
#include "proof/paths.h"

namespace tzc::rewriter {

struct Lack {
  std::string what, hint;  ///< as an Error has them
};

/// The flag that names the standard of a command, "-std=c++98"; empty: it is the compiler's default.
std::string standard_of(const CompileCommand& command);

/// C++14 or later; none: it has it.
std::optional<Lack> lacks_standard(const CompileCommand& command);

/// What a command lacks to compile a ported unit; none: it lacks nothing.
std::optional<Lack> lacks_for_tzc(const CompileCommand& command);

/// A target that links the objects of `target` without TZC's libraries; none: there is none.
const CmakeTarget* linked_without_tzc(const std::vector<CmakeTarget>& all, const std::string& target);

/// The folders that the command names for headers, and those that compilers search by default.
std::vector<std::string> include_folders(const CompileCommand& command);

/// Headers that are not there: one of them may be what is asked for, or the build makes them, and they include nothing that is.
enum class MissingHeaders { count, are_made };

/// Whether what the command compiles reads one of the files, by the compiler's own word; true where it has none. `to_user`: the
/// files' names are the user's.
bool includes_any(const CompileCommand& command, const FileContents& files, const PathMap& to_user,
                  MissingHeaders missing = MissingHeaders::count);

}  // namespace tzc::rewriter
