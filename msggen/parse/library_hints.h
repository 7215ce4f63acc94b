// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "parse/package_path.h"

namespace tzc::msggen {

/// What is known of the package that should have had a type.
struct KnownPackage {
  std::vector<std::string> folders;
  std::vector<std::string> names;  ///< types that have been read already
};

/// A hint for a package that no -I names: the -I that helps, or the nearest name.
std::string package_hint(const std::string& package, const SearchPath& path, const PackageIndex& installed,
                         bool installed_was_searched);

/// A hint for a type that its package does not have: the package that has it, or the nearest name.
std::string type_hint(const std::string& package, const std::string& name, const KnownPackage& known,
                      const SearchPath& path, const PackageIndex& installed);

}  // namespace tzc::msggen
