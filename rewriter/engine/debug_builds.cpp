// SPDX-License-Identifier: BSD-3-Clause
#include "engine/debug_builds.h"

#include <string>

namespace tzc::rewriter {
namespace {

/// The last of -DNDEBUG, -D NDEBUG and -UNDEBUG counts.
bool defines_ndebug(const CompileUnit& unit) {
  bool defines = false;
  std::string option;  // whose value comes next
  for (const std::string& argument : unit.arguments) {
    const std::string text = option + argument;
    option = argument == "-D" || argument == "-U" ? argument : "";
    if (text == "-DNDEBUG" || text.rfind("-DNDEBUG=", 0) == 0) defines = true;
    if (text == "-UNDEBUG") defines = false;
  }
  return defines;
}

}  // namespace

std::optional<CompileUnit> debug_build_of(const CompileUnit& unit) {
  if (!defines_ndebug(unit)) return {};
  CompileUnit build = unit;
  build.arguments.emplace_back("-UNDEBUG");
  return build;
}

}  // namespace tzc::rewriter
