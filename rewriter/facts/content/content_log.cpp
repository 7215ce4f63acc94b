// SPDX-License-Identifier: BSD-3-Clause
#include "facts/content/content_log.h"

#include "facts/content/unfollowed_messages.h"

namespace tzc::rewriter {

ContentEvent ContentLog::event(ContentEvent::Kind kind, MessagePart part, clang::SourceLocation where) const {
  ContentEvent event;
  event.kind = kind;
  event.part = std::move(part);
  event.where = unit_.location(where);
  return event;
}

void ContentLog::add(ContentEvent::Kind kind, MessagePart part, clang::SourceLocation where) {
  if (!part.empty()) step(event(kind, std::move(part), where));
}

void ContentLog::pair(ContentEvent::Kind kind, MessagePart part, MessagePart other,
                      clang::SourceLocation where) {
  if (part.empty() || other.empty()) return;
  ContentEvent two = event(kind, std::move(part), where);
  two.other = std::move(other);
  step(std::move(two));
}

void ContentLog::copy(MessagePart message, MessagePart original, clang::SourceLocation where) {
  if (message.empty()) return;
  ContentEvent copied = event(ContentEvent::Kind::copy, std::move(message), where);
  copied.other = std::move(original);
  step(std::move(copied));
}

void ContentLog::publish(MessagePart part, PublishPlace site, clang::SourceLocation where) {
  if (part.empty()) return;
  ContentEvent published = event(ContentEvent::Kind::publish, std::move(part), where);
  published.site = std::move(site);
  step(std::move(published));
}

void ContentLog::assign(MessagePart part, bool empties, clang::SourceLocation where) {
  if (part.empty()) return;
  ContentEvent reset = event(ContentEvent::Kind::reset, std::move(part), where);
  reset.empties = empties;
  step(std::move(reset));
}

void ContentLog::any(const clang::Expr* message) {
  const std::string type = message ? unfollowed_type(unit_, parts_, message) : std::string();
  if (!type.empty()) any(message, type);
}

void ContentLog::any(const clang::Expr* expr, const std::string& type) {
  ContentEvent any = event(ContentEvent::Kind::any, any_message(type), expr->getExprLoc());
  const FlowSources sources = flow_.sources_of(expr);
  if (!sources.foreign) any.named_by.insert(sources.entities.begin(), sources.entities.end());
  step(std::move(any));
}

}  // namespace tzc::rewriter
