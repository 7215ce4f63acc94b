// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "weak/event.h"

namespace tzc {
namespace model {
namespace weak {

/// Thrown by a thread that needs the next operation to happen.
struct Pending {
  Operation operation;
};

/// What a running thread sees of the world. It runs from its start each time, is fed the results that it already got,
/// and stops at the first operation that has none yet.
class Context {
 public:
  /// Changes an operation before it happens: a planted mistake.
  using Filter = std::function<void(Operation&)>;

  Context(const std::vector<Word>& results, const Filter& filter) : results_(results), filter_(filter) {}

  Word perform(Operation operation) {
    if (next_ < results_.size()) return results_[next_++];
    if (filter_) filter_(operation);
    throw Pending{operation};
  }
  /// What the thread wants to tell at the end.
  void note(Word value) { notes_.push_back(value); }
  const std::vector<Word>& notes() const { return notes_; }
  void require(bool holds, const char* otherwise) const {
    if (!holds) throw Violation{otherwise};
  }

 private:
  const std::vector<Word>& results_;
  const Filter& filter_;
  std::size_t next_ = 0;
  std::vector<Word> notes_;
};

/// Looks like std::atomic to the code under test. compare_exchange_weak does not fail without a reason: after such
/// a failure the caller is where it was before.
class Atomic {
 public:
  Atomic(Context& context, std::size_t location) : context_(context), location_(location) {}

  Word load(std::memory_order order = std::memory_order_seq_cst) const {
    return perform(Operation::load, 0, order);
  }
  void store(Word value, std::memory_order order = std::memory_order_seq_cst) {
    perform(Operation::store, value, order);
  }
  Word fetch_add(Word value, std::memory_order order) { return perform(Operation::fetch_add, value, order); }
  Word fetch_or(Word value, std::memory_order order) { return perform(Operation::fetch_or, value, order); }
  Word exchange(Word value, std::memory_order order) { return perform(Operation::exchange, value, order); }
  bool compare_exchange_weak(Word& expected, Word desired, std::memory_order success,
                             std::memory_order failure) {
    Operation operation{Operation::compare_exchange, location_, success, failure, desired, expected, true};
    const Word before = context_.perform(operation);
    if (before == expected) return true;
    expected = before;
    return false;
  }
  /// A mutex: waits until the word is 0, then makes it 1. To release there orders nothing: only unlock reads the 1.
  void lock() { perform(Operation::lock, 0, std::memory_order_acq_rel); }
  void unlock() { store(0, std::memory_order_release); }
  /// Waits until a read can return the value.
  void await(Word value, std::memory_order order) const { perform(Operation::await, value, order); }

 private:
  Word perform(Operation::Kind kind, Word operand, std::memory_order order) const {
    Operation operation;
    operation.kind = kind;
    operation.location = location_;
    operation.order = order;
    operation.operand = operand;
    return context_.perform(operation);
  }

  Context& context_;
  std::size_t location_;
};

/// Memory that is no atomic: a race for it is a violation.
class Plain {
 public:
  Plain(Context& context, std::size_t location) : context_(context), location_(location) {}
  Word read() const { return perform(Operation::load, 0); }
  void write(Word value) { perform(Operation::store, value); }

 private:
  Word perform(Operation::Kind kind, Word operand) const {
    Operation operation;
    operation.kind = kind;
    operation.location = location_;
    operation.operand = operand;
    operation.atomic = false;
    return context_.perform(operation);
  }

  Context& context_;
  std::size_t location_;
};

inline void fence(Context& context, std::memory_order order) {
  Operation operation;
  operation.kind = Operation::fence;
  operation.order = order;
  context.perform(operation);
}

}  // namespace weak
}  // namespace model
}  // namespace tzc
