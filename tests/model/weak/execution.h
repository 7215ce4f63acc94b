// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "weak/event.h"

namespace tzc {
namespace model {
namespace weak {

/// Whether programs with a relaxed write after a relaxed read are refused (execution.cpp).
enum class Scope { without_load_buffering, everything };

/// One execution of a program, or the beginning of one: its events, which write each read reads from, and the order
/// of the writes to each location. It grows by one event at a time and stays consistent with the model RC11:
///
///   coherence   hb; eco? is irreflexive
///   atomicity   nothing comes between an update and the write that it reads from
///   SC          psc is acyclic (sequential_order.cpp)
///   no cycles of program order and reads-from, because an event reads only from what is there already
///
/// (Lahav, Vafeiadis, Kang, Hur, Dreyer, "Repairing sequential consistency in C/C++11", PLDI 2017). Release sequences
/// are those of C++20: updates alone continue them. A new event is the last of its thread, so what happens before the
/// events that are there never changes.
class Execution {
 public:
  /// Location i begins with initial[i], which happens before everything.
  Execution(std::size_t threads, const std::vector<Word>& initial, Scope scope);

  const std::vector<Event>& events() const { return events_; }
  /// The writes to a location, in modification order.
  const std::vector<std::size_t>& writes_to(std::size_t location) const { return writes_[location]; }
  Word last_value(std::size_t location) const { return events_[writes_[location].back()].value_written; }

  /// Executions with the operation as the thread's next event, with what it returns, one for each choice of what it
  /// reads from and where in modification order it comes. Throws Violation: a data race, or out of scope.
  std::vector<std::pair<Execution, Word>> extended(std::size_t thread, const Operation& operation) const;

  /// Equal for executions that are equal, in whatever order their events were added.
  std::pair<std::uint64_t, std::uint64_t> key() const;

 private:
  struct Thread {
    std::vector<std::size_t> events;
    EventSet before_fence;  // what an acquire fence would synchronize with
    EventSet release_fences;
    std::vector<std::size_t> relaxed_reads;   // the events, since the last fence
    std::vector<std::size_t> release_writes;  // to each location, the last one's event
  };

  Event next_event(std::size_t thread, const Operation& operation) const;
  void extend_reading(const Event& event, const Operation& operation,
                      std::vector<std::pair<Execution, Word>>& all) const;
  void extend_writing(const Event& event, std::vector<std::pair<Execution, Word>>& all) const;
  void extend_fence(const Event& event, std::vector<std::pair<Execution, Word>>& all) const;
  bool may_insert(std::size_t location, std::size_t position) const;
  /// False: inconsistent.
  bool add(Event event, std::size_t position);
  void synchronize(Event& event);
  void order_after(Event& event, const EventSet& released) const;
  void check_race(const Event& event) const;
  void check_load_buffering(const Event& event);
  bool may_precede_a_read(const Event& write) const;
  bool is_coherent(const Event& event, std::size_t position) const;
  std::size_t position_of(std::size_t write) const;
  bool is_sequentially_consistent() const;

  Scope scope_;
  std::vector<Event> events_;
  std::vector<std::vector<std::size_t>> writes_;
  std::vector<Thread> threads_;
};

/// psc is acyclic.
bool has_sequential_order(const std::vector<Event>& events,
                          const std::vector<std::vector<std::size_t>>& writes);

}  // namespace weak
}  // namespace model
}  // namespace tzc
