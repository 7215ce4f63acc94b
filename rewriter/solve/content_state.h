// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <set>

#include "model/content_flow.h"

namespace tzc::rewriter {

/// Whether the part is the whole, or lies inside it: an element of a message's own array does, one of the program's container is another message.
bool lies_in(const MessagePart& part, const MessagePart& whole);

/// Where a message gets elements that lie outside shared memory.
struct Taken {
  Location where;
  bool by_copy = false;  ///< of another message
};

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
  /// The part has no content from here on, or other content, which nobody shares.
  void reset(const MessagePart& part);
  /// It has elements, which no publish has shared yet. Those of a copy, which has no memory of its own, lie outside shared memory.
  void fill(const MessagePart& part);
  /// The part has the elements of a std::vector, or of a copy, from here on.
  void take(const MessagePart& part, const Taken& taken);
  /// Whether something in it, or all of what it is a part of, may have such elements.
  bool is_unsent(const MessagePart& part) const;
  /// The message is a copy of another one from here on: it shares what that one's publishes share, and has elements of its own
  /// outside shared memory where those were not published, or are not known (an empty part).
  void copy(const MessagePart& message, const MessagePart& original, const Location& where);
  /// Where a part of it was given such elements; none: it was not. Who has published it before shares it as well.
  std::optional<Taken> publish(const MessagePart& part, const PublishPlace& site);
  /// These sites share it from here on, also where it had become its owner's, and where they did already.
  void share_anew(const MessagePart& part, const std::set<PublishPlace>& sites);
  /// Each part has from here on what the other one had. Objects stay bound to the memory that they are bound to.
  void exchange(const MessagePart& one, const MessagePart& other);
  /// The pointer leads from here on to what the other part is. What it led to keeps its content under its other names.
  void alias(const MessagePart& pointer, const MessagePart& other);
  /// The pointer may lead to what the other part is from here on.
  void alias_perhaps(const MessagePart& pointer, const MessagePart& other);
  /// The publishes whose elements a write to the array copies. Afterwards the array has its own again (fill).
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
  std::map<MessagePart, std::set<PublishPlace>> shared_;
  std::set<MessagePart> own_;     ///< inside shared parts
  std::set<MessagePart> unsent_;  ///< that have elements, perhaps, which no publish has shared
  std::map<MessagePart, Taken> taken_;
  std::map<MessagePart, Taken>
      borrowed_;  ///< copies that have the elements of others as long as nobody writes
  std::set<MessagePart> new_;
};

}  // namespace tzc::rewriter
