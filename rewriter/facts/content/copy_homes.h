// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "facts/content/message_holders.h"

namespace tzc::rewriter {

/// What a copy of a message becomes part of where it is made.
struct CopyHome {
  std::string
      holder;  ///< empty: nothing that has a name, or a message that the analysis of its component speaks of
  std::string how;  ///< "copied into 'frames'"
};

/// Finds it: from the expression that makes the copy up through the objects that are made of it.
class CopyHomes {
 public:
  CopyHomes(const Unit& unit, const FunctionView& view);

  CopyHome of(const clang::Expr* made) const;
  /// Whether the expression is an entry that each run of the function makes anew: frames["left"] of a map that the function declares.
  bool is_new_entry(const clang::Expr* expr) const;

 private:
  CopyHome of_declaration(const clang::DeclStmt* statement, const clang::Stmt* value) const;
  CopyHome of_call(const clang::CallExpr* call, const clang::Stmt* argument) const;
  CopyHome of_result(const clang::Stmt* statement) const;
  CopyHome of_member(const clang::FieldDecl* field) const;
  CopyHome of_initializer(const clang::Stmt* value) const;
  bool may_last(const clang::VarDecl* variable, const clang::Stmt* use) const;

  const Unit& unit_;
  const FunctionView& view_;
  const MessageParts parts_;
  const MessageHolders holders_;
};

}  // namespace tzc::rewriter
