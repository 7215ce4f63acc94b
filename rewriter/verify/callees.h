// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "model/folder_set.h"
#include "verify/instances.h"

namespace clang {
class ASTContext;
}

namespace tzc::rewriter {

/// A call of one of the package's functions, or a constructor that takes a list of elements, as overload resolution picked it;
/// or a function that is an instantiation, at its begin.
struct PackageCall {
  std::string file;  ///< of the call
  unsigned line = 0;
  std::string
      callee_file;  ///< of the function's first declaration; empty: it is none of the package's, or begins here
  unsigned callee_line = 0;
  std::string callee;  ///< its name, with "(lambda)" for a closure
  Instance instance = {};
  unsigned callee_number =
      0;  ///< how many functions the callee's file has in front of it: several may stand on one line
};

/// Unit id -> its calls.
using CallsOfUnits = std::map<std::string, std::vector<PackageCall>>;

/// In the order in which the unit reads them. Edits must leave what they pick as it is: an edit that makes a call pick another
/// function would change what the program does, and still compile.
std::vector<PackageCall> package_calls(clang::ASTContext& ast, const FolderSet& packages);

}  // namespace tzc::rewriter
