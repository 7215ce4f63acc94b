// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "model/file_accesses.h"
#include "proof/paths.h"

namespace tzc::rewriter {

/// Notes what a configuration of a scratch workspace has read, as CMake's file API lists it, under the user's paths.
/// Beside a package's CMake files lie scripts and templates that they use and CMake does not list, so their whole
/// folder counts.
void note_cmake_reads(const std::string& build_dir, const PathMap& to_user, FileAccesses& accesses);

}  // namespace tzc::rewriter
