// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <set>
#include <string>
#include <vector>

#include "facts/facts.h"
#include "facts/parse.h"
#include "rules/rule.h"

namespace tzc::rewriter {

struct CollectOptions {
  std::string package_dir;
  std::string build_dir;
  std::set<std::string> exported_dirs;  ///< of headers that other packages may include
  const RuleSet* rules;
  std::vector<std::string>
      include_dirs;  ///< TZC's: the package may be ported already, its build folder older
};

/// Parses one unit and collects its facts. The errors, when it does not parse.
std::vector<Diagnostic> collect_unit(const CompileUnit& unit, const CollectOptions& options, Facts& facts);

/// The include folders that the package's CMakeLists.txt exports.
std::set<std::string> exported_dirs(const std::string& package_dir);

}  // namespace tzc::rewriter
