// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <set>

#include "model/content_flow.h"

namespace tzc::rewriter {

/// Whether the part is the whole, or lies inside it.
bool lies_in(const MessagePart& part, const MessagePart& whole);

/// Which messages' elements are shared with subscribers, or lie outside shared memory, at one point of a program, on some
/// path to it; and which messages are new there, on each path. Of one of several messages (is_one_of_several) nothing is ever
/// taken away: it may have been another one.
class ContentState {
 public:
  /// Gives a part its name in another function; empty: it has none there.
  using Renaming = std::function<MessagePart(const MessagePart&)>;

  /// The message is a new one, not bound to any memory, whichever path leads here.
  void make(const MessagePart& message);
  bool is_new(const MessagePart& part) const;
  /// The part has content of its own from here on, or none.
  void reset(const MessagePart& part);
  /// The part has the elements of a std::vector from here on.
  void take(const MessagePart& part, const Location& where);
  /// Where a part of it was given a vector's elements; none: it was not. Who has published it before shares it as well.
  std::optional<Location> publish(const MessagePart& part, const PublishPlace& site);
  /// Another name of what is published.
  void publish_as(const MessagePart& other, const PublishPlace& site) { share_anew(other, {site}); }
  /// Each part has from here on what the other one had. Objects stay bound to the memory that they are bound to.
  void exchange(const MessagePart& one, const MessagePart& other);
  /// The pointer leads from here on to what the other part is. What it led to keeps its content under its other names.
  void alias(const MessagePart& pointer, const MessagePart& other);
  /// The pointer may lead to what the other part is from here on.
  void alias_perhaps(const MessagePart& pointer, const MessagePart& other);
  /// The publishes whose elements a write to the array copies. Afterwards the array has its own again.
  std::set<PublishPlace> write(const MessagePart& array);

  /// Adds what another path brings. False: it brings nothing new.
  bool join(const ContentState& other);
  /// Adds what code may leave that runs in between, or not. What is new stays new.
  void join_others(const ContentState& other);
  /// Adds what is known of other parts.
  void add(const ContentState& other);
  /// False: these sites share it already.
  bool share(const MessagePart& part, const std::set<PublishPlace>& sites);
  void unshare(const MessagePart& part);
  /// What is left of it under other names.
  ContentState renamed(const Renaming& rename) const;
  /// The sites that share a part around this one, or the part itself; none: nobody does.
  std::set<PublishPlace> sharers_of(const MessagePart& part) const;

 private:
  bool is_own(const MessagePart& part) const;
  void share_anew(const MessagePart& part, const std::set<PublishPlace>& sites);

  std::map<MessagePart, std::set<PublishPlace>> shared_;
  std::set<MessagePart> own_;  ///< inside shared parts
  std::map<MessagePart, Location> taken_;
  std::set<MessagePart> new_;
};

}  // namespace tzc::rewriter
