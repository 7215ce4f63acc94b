// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <clang/AST/ASTContext.h>
#include <clang/AST/DeclCXX.h>

#include <map>
#include <set>
#include <string>
#include <vector>

#include "parse/names.h"
#include "parse/source.h"
#include "rules/rule.h"

namespace tzc::rewriter {

/// One translation unit, as the collectors of facts see it. Immutable.
struct Unit {
  Source source;
  const RuleSet& rules;
  std::set<std::string> exported_dirs;    ///< folders and headers that others may include
  std::vector<std::string> include_dirs;  ///< where headers are looked for
  /// Functions that the workspace says to keep nothing, with the reason that it gives.
  const std::map<std::string, std::string>& trusted;
  bool layouts_stay =
      false;  ///< other packages compile exported headers as they were, private members included

  clang::ASTContext& ast() const { return source.ast(); }

  /// Whether the package declares the function; false for null.
  bool declares(const clang::FunctionDecl* function) const;
  /// Whether a call of the function can only run code of the package: its body, or an override, of which the package has
  /// each (Facts::overrides). Others may derive from what an exported header declares.
  bool declares_all_of(const clang::FunctionDecl* function) const;
  /// Whether a header that other packages may include has the location.
  bool exports(clang::SourceLocation location) const;
  /// Whether other packages may call the function, or override it, by a declaration that therefore stays as it is.
  bool exports(const clang::FunctionDecl* function) const;
  /// Whether the TZC header of a message can be included: "sensor_msgs/Image".
  bool has_twin(const std::string& message) const;

  Location location(clang::SourceLocation where) const { return location_of(source.where(where)); }
  /// The offset in its file, macros expanded.
  unsigned offset(clang::SourceLocation where) const { return source.where(where).begin; }
  std::string text(const clang::Stmt* stmt) const { return source.text(stmt->getSourceRange()); }
  /// The same without white space, to compare expressions. Empty where a macro writes any of it.
  std::string squeezed(const clang::Stmt* stmt) const;
};

}  // namespace tzc::rewriter
