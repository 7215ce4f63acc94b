// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <clang/AST/Decl.h>

#include <optional>

#include "facts/syntax/unit.h"
#include "model/facts.h"

namespace tzc::rewriter {

/// `ros::Publisher a, b;` for b: the declarator in front of it, and the edit that would begin a declaration of its own.
struct SharedDeclaration {
  const clang::DeclaratorDecl* left;
  Place type;                 ///< the words that the declarators share, where they are written
  Place at;                   ///< the comma, and what stands between it and the declarator
  std::string before, after;  ///< what replaces `at`, around those words
};

/// None: nothing is declared in front of it, or the declaration cannot be cut there.
std::optional<SharedDeclaration> shared_declaration(const Unit& unit, const clang::DeclaratorDecl* decl);

/// A piece of text with the edits that lie in it.
std::string with_changes(const Place& piece, std::string text, const std::vector<Change>& changes);

}  // namespace tzc::rewriter
