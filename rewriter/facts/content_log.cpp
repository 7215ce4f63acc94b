// SPDX-License-Identifier: BSD-3-Clause
#include "facts/content_log.h"

#include "facts/unfollowed_messages.h"

namespace tzc::rewriter {

ContentEvent ContentLog::event(ContentEvent::Kind kind, MessagePart part, clang::SourceLocation where) const {
  ContentEvent event;
  event.kind = kind;
  event.part = std::move(part);
  event.where = unit_.location(where);
  return event;
}

void ContentLog::add(ContentEvent::Kind kind, MessagePart part, clang::SourceLocation where) {
  if (!part.empty()) events_.push_back(event(kind, std::move(part), where));
}

void ContentLog::pair(ContentEvent::Kind kind, MessagePart part, MessagePart other,
                      clang::SourceLocation where) {
  if (part.empty() || other.empty()) return;
  events_.push_back(event(kind, std::move(part), where));
  events_.back().other = std::move(other);
}

void ContentLog::publish(MessagePart part, PublishPlace site, clang::SourceLocation where) {
  if (part.empty()) return;
  events_.push_back(event(ContentEvent::Kind::publish, std::move(part), where));
  events_.back().site = std::move(site);
}

void ContentLog::assign(MessagePart part, bool empties, clang::SourceLocation where) {
  if (part.empty()) return;
  events_.push_back(event(ContentEvent::Kind::reset, std::move(part), where));
  events_.back().empties = empties;
}

void ContentLog::rename(std::size_t first, const MessagePart& from, const MessagePart& to) {
  const auto change = [&](MessagePart& part) {
    const bool is_inside =
        part.compare(0, from.size(), from) == 0 &&
        (part.size() == from.size() || part[from.size()] == '/' || part[from.size()] == '[');
    if (is_inside) part.replace(0, from.size(), to);
  };
  for (std::size_t i = first; i < events_.size(); ++i) {
    change(events_[i].part);
    change(events_[i].other);
    for (auto& [parameter, given] : events_[i].passed) change(given);
  }
}

void ContentLog::any(const clang::Expr* message) {
  const std::string type = message ? unfollowed_type(unit_, parts_, message) : std::string();
  if (!type.empty()) add(ContentEvent::Kind::any, any_message(type), message->getExprLoc());
}

}  // namespace tzc::rewriter
