// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <clang/AST/Expr.h>

#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "facts/flow/value_flow.h"
#include "facts/syntax/message_parts.h"
#include "facts/syntax/unit.h"
#include "model/content_flow.h"

namespace tzc::rewriter {

/// A closure's body runs.
struct ClosureRun {
  const clang::FunctionDecl* body = nullptr;  ///< its call operator, or an instance of that
  bool once = false;                          ///< otherwise any number of times, or never
  std::vector<std::pair<MessagePart, MessagePart>>
      given;  ///< roots of its parameters, and what they are given
};

/// A call that may run what the package gave away outside of the function.
inline ContentEvent call_of_others() {
  ContentEvent event;
  event.kind = ContentEvent::Kind::call;
  return event;
}

/// A function is called, or not.
struct PerhapsCall {
  ContentEvent call;
  IfShown if_shown = {};
};

/// A call that may run any closure of the function, or what the package gave away outside of it.
struct UnknownCall {
  IfShown if_shown = {};
};

/// A function of the package is called, which may run what the function gave away itself.
struct CallOfPackage {};

/// What happens next.
using ContentStep = std::variant<ContentEvent, ClosureRun, PerhapsCall, UnknownCall, CallOfPackage>;

/// Collects what statements do to the content of messages, in their order.
class ContentLog {
 public:
  ContentLog(const Unit& unit, ValueFlow& flow, const MessageParts& parts)
      : unit_(unit), flow_(flow), parts_(parts) {}

  /// Nothing where the part is not known.
  void add(ContentEvent::Kind kind, MessagePart part, clang::SourceLocation where);
  void publish(MessagePart part, PublishPlace site, clang::SourceLocation where);
  /// A message as a whole is given another content, or none.
  void assign(MessagePart part, bool empties, clang::SourceLocation where);
  /// The message is made as a copy of another one, which may be unknown.
  void copy(MessagePart message, MessagePart original, clang::SourceLocation where);
  /// Nothing where one of the parts is not known.
  void pair(ContentEvent::Kind kind, MessagePart part, MessagePart other, clang::SourceLocation where);
  /// The expression names, publishes or passes on a message: an event where nothing shows which. Nothing for null.
  void any(const clang::Expr* message);
  /// The expression leads to messages of the type, and what happens to them is not followed.
  void any(const clang::Expr* expr, const std::string& type);
  void step(ContentStep step) { steps_.push_back(std::move(step)); }

  std::vector<ContentStep> take() { return std::exchange(steps_, {}); }

 private:
  ContentEvent event(ContentEvent::Kind kind, MessagePart part, clang::SourceLocation where) const;

  const Unit& unit_;
  ValueFlow& flow_;
  const MessageParts& parts_;
  std::vector<ContentStep> steps_;
};

}  // namespace tzc::rewriter
