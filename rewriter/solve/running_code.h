// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>

#include "model/facts.h"

namespace tzc::rewriter {

/// Which code of a package may run at the same time as other code: from where it is called, and with which locks.
class RunningCode {
 public:
  using Names = std::set<std::string>;
  /// A place in it.
  struct Spot {
    std::string code;  ///< ThreadFacts
    Names roots;       ///< whom a library, the system or a thread calls to come there
    Names locks;       ///< that the thread has there, whatever the way
  };

  explicit RunningCode(const Facts& facts);

  Spot spot(const std::string& code, const Names& locks) const;
  /// Whether two threads may be there at once, but for locks.
  bool may_meet(const Spot& one, const Spot& other) const;
  /// Whether a thread of its own may come there.
  bool is_for_thread(const Spot& spot) const;
  /// Whether the code, or what it calls, may wait for another thread, or let one go on.
  bool synchronizes(const std::string& code) const { return synchronizing_.count(code) != 0; }

 private:
  struct Call {
    std::string caller;
    Names locks;  ///< that the caller's own code has there
  };

  void add_calls();
  void find_locks();
  Names with_callers(Names codes) const;
  void find_synchronizing();
  bool is_root(const std::string& code) const;
  bool is_run_by_one(const std::string& root) const;
  Names roots_of(const std::string& code) const;
  std::optional<Names> locks_at_entry(const std::string& code) const;

  const Facts& facts_;
  std::map<std::string, std::vector<Call>> calls_;  ///< by the code that is called
  std::map<std::string, Names> locks_;              ///< with which code is entered; none: not known to be
  Names for_threads_;                               ///< code in which threads are seen to meet
  Names synchronizing_;                             ///< and where they may
};

/// The code of an event that a function's effects have.
const std::string& code_of(const std::string& function, const PublishEvent& event);

}  // namespace tzc::rewriter
