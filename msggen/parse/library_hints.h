// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "parse/library.h"

namespace tzc::msggen {

/// What is known of the package that should have had a type.
struct KnownPackage {
  std::vector<std::string> folders;
  std::vector<std::string> names;  ///< types that have been read already
};

/// What to do about a package that nobody named: the -I that helps, or the nearest name.
std::string package_hint(const std::string& package, const SearchPath& path, const PackageIndex& installed,
                         bool installed_was_searched);

/// What to do about a type that its package doesn't have: the package that has it, or the nearest name.
std::string type_hint(const std::string& package, const std::string& name, const KnownPackage& known,
                      const SearchPath& path, const PackageIndex& installed);

}  // namespace tzc::msggen
