// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What units tell about threads.

#include <map>
#include <set>
#include <string>
#include <vector>

#include "model/ids.h"
#include "model/location.h"

namespace tzc::rewriter {

/// A function uses elements of a message.
struct ElementUse {
  enum class Kind {
    look,    ///< at one element, at once
    walk,    ///< what it got at is used later; or it asks for a begin and an end
    write,   ///< to elements, which nobody else may use meanwhile
    rebuild  ///< of the whole array, so that nobody else may use any of it meanwhile
  };
  EntityId message;
  std::string code;       ///< of which thread (ThreadFacts)
  bool captured = false;  ///< by a closure from the function around it
  Kind kind = Kind::look;
  bool read_only = false;       ///< through const access, which moves no element
  std::set<std::string> locks;  ///< that its thread has there (ThreadFacts)
  Location where;
};

/// Where code is handed over to be called.
struct CodeStarts {
  std::set<std::string> by_one;  ///< places where it goes to what runs it on one thread at a time
  bool by_any = false;           ///< it goes to something else, too
  bool by_thread = false;        ///< it goes to a thread, or to something that may have one
};

/// What threads may do to each other. Code is a function, by its USR, or a closure that another thread may call, by its place in braces. A
/// lock is named by the mutex: the USRs of the variable or field, and of the objects around it.
struct ThreadFacts {
  std::set<EntityId> changing;          ///< publishers that change when others may see them
  std::set<std::string> locking;        ///< functions in whose bodies threads may wait for each other, by USR
  std::set<std::string> synchronizing;  ///< code in which threads may wait for each other, in any way
  std::set<std::string> handing_over;   ///< code that gives code to others, which a thread may run
  std::vector<ElementUse> element_uses;
  std::map<std::string, CodeStarts> starts;  ///< of code that is handed over
};
/// Begins the names of mutexes that are variables of a function: another call of it has another one.
constexpr const char* local_lock = "local ";

}  // namespace tzc::rewriter
