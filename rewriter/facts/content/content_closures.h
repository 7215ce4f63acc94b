// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <clang/AST/ExprCXX.h>

#include <vector>

#include "facts/content/content_log.h"
#include "facts/syntax/function_view.h"
#include "facts/syntax/message_parts.h"
#include "facts/syntax/unit.h"

namespace tzc::rewriter {

/// Reads when the bodies of a function's closures run, and with which messages.
class ContentClosures {
 public:
  ContentClosures(const FunctionView& view, const MessageParts& parts, ContentLog& log)
      : view_(view), parts_(parts), log_(log) {}

  /// A closure comes into being. Who is given it may call it at once.
  void made(const clang::LambdaExpr* lambda);
  /// False: it is no call of a closure.
  bool called(const clang::CallExpr* call);
  /// A library's function gives a closure what it was given itself: std::for_each(begin, end, [](Image& image) { ... })
  void given_to(const clang::CallExpr* call);

 private:
  bool is_own_closure(const clang::CXXMethodDecl* function) const;
  void run(const clang::FunctionDecl* body, bool once, llvm::ArrayRef<const clang::Expr*> arguments);

  const FunctionView& view_;
  const MessageParts& parts_;
  ContentLog& log_;
};

/// What a call of a closure runs: its body; of a generic one, the body of one of its instances. What is dependent never runs.
std::vector<const clang::FunctionDecl*> bodies_of(const clang::LambdaExpr* lambda);

/// The bodies of the closures of a function, and of those that the instances of its generic ones make, which something else than a
/// direct call may run.
std::vector<const clang::FunctionDecl*> bodies_run_elsewhere(const FunctionView& view);

/// The roots of those of a closure's parameters and variables that hold or name messages: each call of it has its own. What it captures
/// belongs to the closure itself.
std::vector<MessagePart> own_roots(const MessageParts& parts, const clang::FunctionDecl* body);

}  // namespace tzc::rewriter
