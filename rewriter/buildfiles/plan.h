// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <set>
#include <string>
#include <vector>

#include "model/edit.h"
#include "model/expected.h"
#include "model/report.h"

namespace tzc::rewriter {

/// What the ported sources need from the build files.
struct BuildNeeds {
  std::string package_dir;
  std::string build_dir;               ///< with compile_commands.json
  std::set<std::string> main_files;    ///< whose targets need TZC; canonical
  std::set<std::string> edited_files;  ///< to see whether an exported header changed
  std::set<std::string> tzc_types;     ///< "pkg/Type": twins that the ported code includes
  std::set<std::string> twinless;      ///< packages of tzc_types whose twins no other build makes
  bool dual = false;                   ///< the package must still build where TZC is not
};

struct BuildPlan {
  Edits edits;
  std::vector<Note> notes;  ///< what the user has to do by hand
};

/// Edits of package.xml and CMakeLists.txt. Minimal and idempotent. Where an edit is not safe it makes a note
/// with an instruction, never a guess. An error when a file cannot be read.
Expected<BuildPlan> plan_build_files(const BuildNeeds& needs);

/// Whether a message package has tzc among its catkin components, so that its own build makes its twins.
bool makes_own_twins(const std::string& package_dir);

}  // namespace tzc::rewriter
