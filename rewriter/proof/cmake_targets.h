// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <set>
#include <string>
#include <vector>

namespace tzc::rewriter {

/// A target of a configured build tree, from CMake's file API (codemodel-v2).
struct CmakeTarget {
  std::string name;
  std::string type;                   ///< "EXECUTABLE", "STATIC_LIBRARY", ...
  std::string product;                ///< file name of what is made; empty: nothing
  std::set<std::string> sources;      ///< absolute
  std::vector<std::string> linked;    ///< words of the link line
  std::set<std::string> made_before;  ///< names of the targets that it depends on

  bool is_linked() const {
    return type == "EXECUTABLE" || type == "SHARED_LIBRARY" || type == "MODULE_LIBRARY";
  }
  bool links(const std::string& library_prefix) const;
};

/// Empty where CMake wrote no reply (before 3.14), or one that is not understood.
std::vector<CmakeTarget> read_cmake_targets(const std::string& build_dir);

/// The targets that link the objects of `target`: itself, or those that link the library.
std::vector<const CmakeTarget*> linked_with(const std::vector<CmakeTarget>& all, const CmakeTarget& target);

}  // namespace tzc::rewriter
