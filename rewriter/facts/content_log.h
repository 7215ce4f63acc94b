// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <clang/AST/Expr.h>

#include <utility>
#include <vector>

#include "facts/message_parts.h"
#include "facts/unit.h"
#include "model/content_flow.h"

namespace tzc::rewriter {

/// Collects what statements do to the content of messages, in their order.
class ContentLog {
 public:
  ContentLog(const Unit& unit, const MessageParts& parts) : unit_(unit), parts_(parts) {}

  /// Nothing where the part is not known.
  void add(ContentEvent::Kind kind, MessagePart part, clang::SourceLocation where);
  void publish(MessagePart part, PublishPlace site, clang::SourceLocation where);
  /// A message as a whole is given another content, or none.
  void assign(MessagePart part, bool empties, clang::SourceLocation where);
  /// Nothing where one of the parts is not known.
  void pair(ContentEvent::Kind kind, MessagePart part, MessagePart other, clang::SourceLocation where);
  /// The expression names, publishes or passes on a message: an event where nothing shows which. Nothing for null.
  void any(const clang::Expr* message);
  void call(ContentEvent event) { events_.push_back(std::move(event)); }
  /// What follows may not happen, up to the call of end() that belongs to it.
  void begin() { events_.push_back(event(ContentEvent::Kind::begins, {}, {})); }
  void end() { events_.push_back(event(ContentEvent::Kind::ends, {}, {})); }

  std::size_t size() const { return events_.size(); }
  /// In the events from the given one on, what lies in a part lies in another instead.
  void rename(std::size_t first, const MessagePart& from, const MessagePart& to);

  std::vector<ContentEvent> take() { return std::exchange(events_, {}); }

 private:
  ContentEvent event(ContentEvent::Kind kind, MessagePart part, clang::SourceLocation where) const;

  const Unit& unit_;
  const MessageParts& parts_;
  std::vector<ContentEvent> events_;
};

}  // namespace tzc::rewriter
