// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What units tell about pointers into messages' data, and about the content of messages.

#include <map>
#include <set>
#include <string>
#include <vector>

#include "model/content_flow.h"
#include "model/hidden_code.h"
#include "model/ids.h"
#include "model/location.h"
#include "model/obstacle.h"

namespace tzc::rewriter {

/// Something that may publish a message: what a pointer into its data must not live across.
struct PublishEvent {
  /// unknown: code that is not seen here runs; exchange: the elements become another object's; write: an array is written to
  enum class Kind { publish, call, unknown, exchange, write };
  Kind kind = Kind::unknown;
  std::set<EntityId> messages;       ///< that are published or written to, or passed to the callee
  std::string callee;                ///< USR of a function of the package
  std::string closure = {};          ///< that it is in (ThreadFacts); "": the function's own code
  bool captured = false;             ///< the closure names variables of the function around it here
  std::set<std::string> locks = {};  ///< that its thread has there (ThreadFacts)
  IfShown if_shown = {};             ///< hidden code runs; otherwise nothing does
};

/// A pointer into a message's data went where it cannot be followed.
struct DataEscape {
  EntityId message;
  Obstacle obstacle;
  bool ends_with_scope = false;  ///< harmless for a message that ends with its scope soon after its publish
};

/// A pointer into a message's data lives across an event.
struct DataHold {
  EntityId message;
  PublishEvent event;
  Obstacle obstacle;
  bool read_only = false;  ///< got through const access, so that a write, too, may leave it behind
};

/// An event after which statements follow, before the message's end, that may write through a pointer.
struct LoudTail {
  PublishEvent event;
  Obstacle obstacle;
  IfShown if_shown;  ///< what follows is hidden code
};

/// Something that a subscriber should not do with a message that it was given as const.
struct DataWrite {
  EntityId message;
  Obstacle obstacle;
  bool to_array = false;  ///< the array itself may be written to, not only its elements
};

/// A function that is said to keep nothing was given a pointer into a message's data.
struct TrustedCall {
  EntityId message;
  std::string function;
  std::string reason;  ///< as the workspace gives it
};

/// Another object gets the content of a message that outlives functions: a copy when it is made, or what is moved.
struct GivenMessage {
  MessagePart message;  ///< its root; empty: a new one
  std::string holder;   ///< the root of what has the content: a variable, a container, a function's result
  std::string how;      ///< "stored by 'push_back'"
  Location where;
  bool is_copy =
      false;  ///< of a local message, which nothing has published: a copy's elements lie outside shared memory
};

/// Where the content of messages goes that outlive functions, for the levels.
struct GivenFacts {
  std::vector<GivenMessage> messages;
  std::vector<GivenMessage> refills;  ///< of containers: messages are new where others were taken out before
  std::set<std::string> emptied;      ///< containers that messages are taken out of
  /// By the root of what holds a message: the roots of what is made from it afterwards.
  std::map<std::string, std::set<std::string>> handed_on;
  std::map<PublishPlace, std::set<std::string>> published_from;  ///< the roots of what holds the message
};

/// Pointers into messages' data, and what they must not live across.
struct EscapeFacts {
  std::vector<DataEscape> escapes;
  std::vector<DataHold> holds;
  std::vector<LoudTail> loud_tails;
  std::vector<DataWrite> data_writes;
  std::vector<TrustedCall> trusted_calls;
  std::map<std::string, std::vector<PublishEvent>> effects;  ///< what a function does, by USR
  std::set<EntityId> lasting;                                ///< static locals, and what closures hold
  std::set<std::string> early;  ///< functions that run before an object's members are all there, by USR
  std::map<std::string, ContentFlow> contents;  ///< of functions that touch messages' arrays, by USR
  GivenFacts given;
  std::set<std::string> addressed;  ///< functions that something else than a call names, by USR
};

}  // namespace tzc::rewriter
