// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <unordered_set>
#include <utility>
#include <vector>

#include "weak/atomic.h"
#include "weak/execution.h"

namespace tzc {
namespace model {
namespace weak {

using Program = std::function<void(Context&)>;

/// What a finished execution left: each thread's notes, and each location's last value.
struct Outcome {
  std::vector<std::vector<Word>> notes;
  std::vector<Word> last;
};

/// Explores every execution of a few threads that the C++ memory model allows (execution.h).
///
/// A prefix of an execution is extended by the next event of each thread in turn. A write or fence that a thread is
/// about to do comes in every continuation, whatever others do, so it is added before anything else is tried. Each
/// prefix is visited once, however it came about.
class Explorer {
 public:
  std::vector<Program> threads;
  std::vector<Word> initial;  // of each location
  Scope scope = Scope::without_load_buffering;
  /// Asked about each operation that is about to happen; may weaken it.
  std::function<void(std::size_t thread, Operation&)> on_operation;
  /// Called with each finished execution; throws Violation.
  std::function<void(const Outcome&)> on_end;

  /// True: no execution violates anything. A thread that waits for ever is a violation.
  bool explore();
  std::size_t executions() const { return executions_; }
  std::size_t states() const { return visited_.size(); }
  const std::string& violation() const { return violation_; }

 private:
  struct Thread {
    std::vector<Word> results;
    std::vector<Word> notes;
    Operation next;
    bool finished = false;
  };
  struct State {
    Execution execution;
    std::vector<Thread> threads;
  };
  struct KeyHash {
    std::size_t operator()(const std::pair<std::uint64_t, std::uint64_t>& key) const {
      return static_cast<std::size_t>(key.first);
    }
  };

  void visit(const State& state);
  bool step(const State& state, std::size_t thread);
  void run_to_next_operation(Thread& thread, std::size_t index) const;
  void end(const State& state);

  std::unordered_set<std::pair<std::uint64_t, std::uint64_t>, KeyHash> visited_;
  std::size_t executions_ = 0;
  std::string violation_;
};

}  // namespace weak
}  // namespace model
}  // namespace tzc
