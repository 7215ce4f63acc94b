// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <clang/AST/ASTContext.h>
#include <clang/Basic/SourceManager.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "model/folder_set.h"
#include "model/location.h"

namespace tzc::rewriter {

/// The text of one translation unit in terms of files: places, spelled text, lines.
class Source {
 public:
  Source(clang::ASTContext& ast, FolderSet packages);

  /// The file bytes of a token range; none when they come from a macro or lie outside the packages.
  std::optional<Place> place(clang::SourceRange tokens) const;
  /// The empty place in front of a token.
  std::optional<Place> before(clang::SourceLocation location) const;
  /// Where to point a reader to, macros expanded.
  Place where(clang::SourceLocation location) const;
  /// Of a call that a macro makes: where in the macro, from the innermost to the one that is named in the file. What else one macro makes stands
  /// elsewhere in it, and at the same place of the file.
  std::vector<unsigned> offsets_in_macros(clang::SourceLocation location) const;
  bool in_package(clang::SourceLocation location) const;
  std::string text(clang::SourceRange tokens) const;
  std::string text(const Place& place) const;

  /// The end of a statement: behind its semicolon.
  std::optional<Place> behind(clang::SourceRange tokens) const;
  /// The end of the line, when nothing but a comment that ends there stands between the place and it.
  std::optional<Place> line_end(const Place& place) const;
  /// The white space in front of the first character of the place's line.
  std::string indent(const Place& place) const;
  /// Whether nothing but white space stands in front of the place on its line.
  bool starts_line(const Place& place) const;

  /// Canonical path, empty when the location is in no file.
  const std::string& file_of(clang::SourceLocation location) const;
  clang::ASTContext& ast() const { return ast_; }
  const clang::SourceManager& manager() const { return manager_; }

 private:
  Place make(clang::SourceLocation begin, unsigned length) const;
  llvm::StringRef buffer(const Place& place) const;

  clang::ASTContext& ast_;
  const clang::SourceManager& manager_;
  const FolderSet packages_;
  mutable std::map<clang::FileID, std::string> files_;
  mutable std::map<std::string, clang::FileID> ids_;
};

}  // namespace tzc::rewriter
