// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "model/facts.h"
#include "model/folder_set.h"
#include "parse/compile_commands.h"
#include "rules/rule.h"

namespace clang {
class ASTContext;
}

namespace tzc::rewriter {

struct CollectOptions {
  FolderSet packages;
  FolderSet generated;                  ///< what lies in these is no source
  std::set<std::string> exported_dirs;  ///< folders and headers that others may include
  const RuleSet* rules;
  std::vector<std::string> include_dirs;  ///< TZC's: the package may already be ported, but not built since
  std::map<std::string, std::string> trusted;  ///< functions that keep nothing, with the reason
  bool layouts_stay = false;  ///< other packages compile exported headers as they were (--dual)
};

/// The facts of one unit that parses. Limits the AST's traversal scope to the package.
Facts collect_unit(clang::ASTContext& ast, const CompileUnit& unit, const CollectOptions& options);

}  // namespace tzc::rewriter
