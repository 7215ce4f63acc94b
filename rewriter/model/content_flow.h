// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What functions do to the content of messages, in the order of their control flow: plain values, so that functions
// of several translation units can be solved together.

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "model/hidden_code.h"
#include "model/ids.h"
#include "model/location.h"

namespace tzc::rewriter {

/// A message, a part of it or one of its arrays: a root and the fields that lead there, "ROOT/image/data". The root is a
/// variable, a member or a function's parameter.
using MessagePart = std::string;

/// The root of a function's parameter.
inline std::string parameter_root(const std::string& function, unsigned index) {
  return "parameter " + std::to_string(index) + " of " + function;
}

inline bool is_parameter(const MessagePart& part) {
  return part.rfind("parameter ", 0) == 0;
}

/// Members, globals and statics: the same object in each function. Their roots are USRs.
inline bool outlives_functions(const MessagePart& part) {
  return part.rfind("c:", 0) == 0;
}

/// A variable of a function.
inline bool is_local(const MessagePart& part) {
  return part.rfind("local ", 0) == 0;
}

/// A root as it is called outside of its function: that of a variable with the function.
inline std::string root_in(const std::string& function, const std::string& root) {
  return is_local(root) ? root + " of " + function : root;
}

/// The root of what a function returns by value.
inline std::string result_root(const std::string& function) {
  return "result of " + function;
}

/// A part of what a call returned, which has the state that the function left it with.
inline bool is_result(const MessagePart& part) {
  return part.rfind("result of ", 0) == 0;
}

/// One of the messages that an expression chooses from: a conditional operator, std::tie.
inline std::string choice_root(unsigned offset) {
  return "choice " + std::to_string(offset);
}

/// The message that an expression makes as a copy of another one.
inline std::string copy_root(unsigned offset) {
  return "local copy " + std::to_string(offset);
}

inline bool is_copy(const MessagePart& part) {
  return part.rfind("local copy ", 0) == 0;
}

inline bool is_choice(const MessagePart& part) {
  return part.rfind("choice ", 0) == 0;
}

/// A destructor or call operator, by its USR: "c:@S@Guard@F@~Guard#". What holds such an object may call it at any time.
inline bool is_called_by_holders(const std::string& usr) {
  return usr.find("@F@~") != std::string::npos || usr.find("@F@operator()#") != std::string::npos;
}

/// In the name of an element: which one it is may change from one mention to the next.
inline std::string any_element() {
  return "?";
}

/// One of the messages of a container: what happens to it happens perhaps to each, and certainly to none.
inline bool is_one_of_several(const MessagePart& part) {
  return part.find("[?]") != MessagePart::npos;
}

/// The name of an element that may be another one before its function has ended.
inline bool is_fleeting(const MessagePart& part) {
  return is_one_of_several(part) || part.find("@!") != MessagePart::npos;
}

/// Some message of a type that the facts do not follow: it may be any of the package's.
inline MessagePart any_message(const std::string& type) {
  return "any " + type;
}

/// A publish call, without the type that instances of a template give it.
using PublishPlace = std::pair<std::string, unsigned>;  // file, byte offset

struct ContentEvent {
  enum class Kind {
    make,      ///< a message comes into being as a member of an object
    reset,     ///< the part has no content any more, or content that nobody else has
    take,      ///< the array is given elements that lie outside shared memory, those of a std::vector
    write,     ///< an element is written, or may be
    grow,      ///< the array may need other memory, for more elements than it has had
    publish,   ///< the part's elements are shared from here on
    fill,      ///< the part has elements, which nobody shares yet
    copy,      ///< a message comes into being as a copy of `other`; empty: of one that is not known
    exchange,  ///< the part and `other` exchange their elements, or what they point to
    alias,     ///< the pointer leads to what `other` leads to
    perhaps,   ///< the pointer leads to what `other` leads to, or to what it led to before
    moved,  ///< the parts whose names hold `part`, or begin with it, denote other elements of their containers from here on
    any,  ///< some message is written, published or named, and which one is not followed: `part` has its type
    call  ///< of a function of the package
  };
  Kind kind = Kind::write;
  MessagePart part;  ///< of a call: what it returns
  MessagePart other;
  Location where;
  PublishPlace site;     ///< of a publish
  bool empties = false;  ///< a reset that leaves no elements, as message = M(), data.clear()
  std::string callee;    ///< USR of the function that is called; empty: any that others may call
  std::map<std::string, MessagePart> passed;  ///< parameter's root -> what it is given
  std::set<EntityId>
      named_by;  ///< of any: what the expression gets the message from, and has its type; empty: not known
};

bool operator==(const ContentEvent& a, const ContentEvent& b);

struct ContentBlock {
  std::vector<ContentEvent> events;
  std::vector<unsigned> next;
  IfShown if_shown = {};  ///< it is hidden code, and the block is there for it alone

  friend bool operator==(const ContentBlock& a, const ContentBlock& b) {
    return a.next == b.next && a.events == b.events && a.if_shown == b.if_shown;
  }
};

/// One function's events as a graph: block 0 is where it begins.
struct ContentFlow {
  std::vector<ContentBlock> blocks;
  unsigned exit = 0;
  bool makes_object = false;  ///< a constructor: the members are new

  /// Another way in which the function may run, as it is compiled elsewhere.
  void add_alternative(ContentFlow other);
  /// Leaves out hidden code of which none is shown.
  void leave_out_all_but(const std::set<std::string>& shown);
  bool is_empty() const;  ///< of events
};

}  // namespace tzc::rewriter
