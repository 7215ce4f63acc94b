// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "model/expected.h"

namespace tzc::rewriter {

/// The packages of a folder: the folder itself, or all below it that have a package.xml
/// (without CATKIN_IGNORE and hidden folders), and behind symbolic links in it. Canonical, sorted.
Expected<std::vector<std::string>> find_packages_at(const std::string& argument);

}  // namespace tzc::rewriter
