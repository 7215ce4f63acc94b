// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

// Explores every interleaving of a few threads that share a few words.
//
// A thread is a function of what it has seen: it is run from the start of its current round, is fed the
// results that it already got, and stops (by an exception) at the first operation whose result it does not
// have yet. So a state is the shared words, plus each thread's local data at the start of its round and what
// it saw since; no stacks have to be saved, states compare by value, and every state is visited once. What a
// thread does next follows from its part of the state alone, and is found out once for all states that have
// this part. At any point a thread may die instead.

namespace tzc {
namespace model {

using Word = std::uint64_t;

struct Operation {
  enum Kind {
    load,
    compare_exchange,
    store,
    fetch_add,
    fetch_or,
    exchange,
    lock,
    push,
    pop,
    fall_asleep,
    stay_asleep
  } kind;
  std::size_t index;
  Word expected = 0;
  Word desired = 0;
};

/// Thrown by a thread that needs the next operation to happen.
struct Pending {
  Operation operation;
};

/// Thrown by a thread that finds the protocol violated.
struct Violation {
  std::string what;
};

[[noreturn]] inline void violated(const char* what) {
  throw Violation{what};
}

/// What a running thread sees of the world.
class Context {
 public:
  explicit Context(const std::vector<Word>& seen) : seen_(seen) {}

  Word perform(const Operation& operation) {
    if (next_ < seen_.size()) return seen_[next_++];
    throw Pending{operation};
  }

 private:
  const std::vector<Word>& seen_;
  std::size_t next_ = 0;
};

/// Looks like std::atomic<std::uint64_t> to the code under test.
class ModelAtomic {
 public:
  ModelAtomic(Context& context, std::size_t index) : context_(context), index_(index) {}

  Word load(std::memory_order) const { return context_.perform({Operation::load, index_}); }
  void store(Word value, std::memory_order = std::memory_order_seq_cst) {
    context_.perform({Operation::store, index_, 0, value});
  }
  Word fetch_add(Word value, std::memory_order) {
    return context_.perform({Operation::fetch_add, index_, 0, value});
  }
  Word fetch_or(Word value, std::memory_order) {
    return context_.perform({Operation::fetch_or, index_, 0, value});
  }
  Word exchange(Word value, std::memory_order) {
    return context_.perform({Operation::exchange, index_, 0, value});
  }
  bool compare_exchange_weak(Word& expected, Word desired, std::memory_order, std::memory_order) {
    const Word before = context_.perform({Operation::compare_exchange, index_, expected, desired});
    if (before == expected) return true;
    expected = before;
    return false;
  }
  /// A mutex: waits until the word is 0, then makes it 1; store(0) unlocks.
  void lock() { context_.perform({Operation::lock, index_}); }
  /// A bounded queue of 16-bit entries in one word, like a socket; pop waits until something is there or the
  /// other end is closed (0).
  void push(Word entry) { context_.perform({Operation::push, index_, 0, entry}); }
  Word pop() { return context_.perform({Operation::pop, index_}); }
  /// A futex: this word says that a thread sleeps on word `on`, unless that is not `expected`; another thread
  /// wakes it by storing 0.
  void sleep(std::size_t on, Word expected) {
    if (context_.perform({Operation::fall_asleep, index_, expected, on}) != 0)
      context_.perform({Operation::stay_asleep, index_});
  }

 private:
  Context& context_;
  std::size_t index_;
};

/// One thread's program: a round changes `local` and returns false after the last one. Local must be plain
/// data.
template <class Local>
using Program = bool (*)(Context&, Local&, std::size_t thread);

template <class Local, std::size_t threads, std::size_t words>
class Explorer {
 public:
  struct Thread {
    Local local{};
    std::vector<Word> seen;
    bool finished = false;
    bool dead = false;
  };

  struct State {
    std::array<Word, words> shared{};
    std::array<Thread, threads> thread{};
    int deaths = 0;
  };

  std::array<Program<Local>, threads> programs{};
  int most_deaths = 0;
  std::size_t writer = 0;                                  // the thread whose end closes all queues
  void (*on_death)(State&, std::size_t thread) = nullptr;  // what the system does, e.g. hang up
  void (*check_end)(const State&) = nullptr;               // throws Violation

  std::size_t states() const { return visited_.size(); }
  const std::string& violation() const { return violation_; }

  /// True: no reachable state violates anything.
  bool explore(const State& state) {
    if (!visited_.insert(key(state)).second) return true;
    bool can_move = false;
    for (std::size_t i = 0; i < threads; ++i) {
      if (state.thread[i].finished || state.thread[i].dead) continue;
      const Step step = try_step(state, i);
      if (step.violated) return false;
      can_move |= step.moved;
      if (step.moved && !explore_named(step.next, i, "")) return false;
      if (state.deaths < most_deaths && !explore_named(after_death(state, i), i, " dies")) return false;
    }
    return can_move || ends_well(state);
  }

 private:
  struct Step {
    State next;
    bool moved = false;
    bool violated = false;
  };

  /// What a thread does next: an operation, or nothing any more in this round, which leaves `local`.
  struct Outcome {
    Operation operation{};
    bool ends_round = false;
    bool finished = false;
    Local local{};
    std::string violation;
  };

  // Advances thread i by one operation, or through the end of its round.
  Step try_step(const State& state, std::size_t i) {
    Step step{state, false, false};
    Thread& thread = step.next.thread[i];
    const Outcome& outcome = outcome_of(thread, i);
    if (!outcome.violation.empty()) {
      violation_ = "thread " + std::to_string(i) + ": " + outcome.violation;
      step.violated = true;
    } else if (outcome.ends_round) {
      thread.finished = outcome.finished;
      thread.local = outcome.local;
      thread.seen.clear();
      step.moved = true;
    } else {
      Word result = 0;
      step.moved = apply(outcome.operation, step.next, result);
      if (step.moved) thread.seen.push_back(result);
    }
    return step;
  }

  const Outcome& outcome_of(const Thread& thread, std::size_t i) {
    Key of_thread{i, 3};
    mix(of_thread, thread);
    const auto known = outcomes_.find(of_thread);
    return known != outcomes_.end() ? known->second
                                    : outcomes_.emplace(of_thread, run(thread, i)).first->second;
  }

  Outcome run(const Thread& thread, std::size_t i) {
    Outcome outcome;
    outcome.local = thread.local;
    try {
      Context context(thread.seen);
      outcome.finished = !programs[i](context, outcome.local, i);
      outcome.ends_round = true;
    } catch (const Pending& pending) {
      outcome.operation = pending.operation;
    } catch (const Violation& found) {
      outcome.violation = found.what;
    }
    return outcome;
  }

  // False: the operation has to wait.
  bool apply(const Operation& operation, State& state, Word& result) {
    Word& word = state.shared[operation.index];
    result = word;
    switch (operation.kind) {
      case Operation::load:
        return true;
      case Operation::compare_exchange:
        if (word == operation.expected) word = operation.desired;
        return true;
      case Operation::store:
        word = operation.desired;
        return true;
      case Operation::fetch_add:
        word += operation.desired;
        return true;
      case Operation::fetch_or:
        word |= operation.desired;
        return true;
      case Operation::exchange:
        word = operation.desired;
        return true;
      case Operation::lock:
        if (word != 0) return false;
        word = 1;
        return true;
      case Operation::fall_asleep:
        word = result = state.shared[operation.desired] == operation.expected ? 1 : 0;
        return true;
      case Operation::stay_asleep:
        return word == 0;
      case Operation::push:
        push(word, operation.desired);
        return true;
      case Operation::pop:
        result = pop(word);
        return result != 0 || state.thread[writer].finished || state.thread[writer].dead;
    }
    return false;
  }

  static void push(Word& queue, Word entry) {
    int shift = 0;
    while (queue >> shift & 0xffff) shift += 16;
    queue |= entry << shift;
  }

  static Word pop(Word& queue) {
    const Word oldest = queue & 0xffff;
    queue >>= 16;
    return oldest;
  }

  State after_death(const State& state, std::size_t i) {
    State next = state;
    next.thread[i].dead = true;
    next.thread[i].seen.clear();
    ++next.deaths;
    if (on_death) on_death(next, i);
    return next;
  }

  bool explore_named(const State& state, std::size_t i, const char* what) {
    if (explore(state)) return true;
    if (trace_.size() < 4096) trace_ = std::to_string(i) + what + " " + trace_;
    return false;
  }

  bool ends_well(const State& state) {
    try {
      if (check_end) check_end(state);
      return true;
    } catch (const Violation& found) {
      violation_ = "at the end: " + found.what;
      return false;
    }
  }

  // States are compared by 128 bits of hash over their whole content: of a million states, two would have to
  // agree in all of them (once in 10^26 explorations) for one to be missed.
  using Key = std::pair<std::uint64_t, std::uint64_t>;
  struct KeyHash {
    std::size_t operator()(const Key& key) const { return static_cast<std::size_t>(key.first); }
  };

  static void mix(Key& key, std::uint64_t value) {
    key.first = (key.first ^ value) * 0x9e3779b97f4a7c15;
    key.first ^= key.first >> 32;
    key.second = (key.second + value) * 0xd6e8feb86659fd93;
    key.second ^= key.second >> 29;
  }

  static void mix(Key& key, const Thread& thread) {
    const auto* bytes = reinterpret_cast<const unsigned char*>(&thread.local);
    for (std::size_t i = 0; i < sizeof thread.local; i += sizeof(Word)) {
      Word word = 0;
      std::memcpy(&word, bytes + i, std::min(sizeof word, sizeof thread.local - i));
      mix(key, word);
    }
    for (const Word word : thread.seen) mix(key, word);
    mix(key, thread.seen.size() * 4 + (thread.finished ? 1 : thread.dead ? 2 : 0));
  }

  static Key key(const State& state) {
    Key key{1, 2};
    for (const Word word : state.shared) mix(key, word);
    for (const Thread& thread : state.thread) mix(key, thread);
    return key;
  }

  std::unordered_set<Key, KeyHash> visited_;
  std::unordered_map<Key, Outcome, KeyHash> outcomes_;
  std::string violation_;
  std::string trace_;

 public:
  /// The threads that moved, in order, up to the violation.
  const std::string& trace() const { return trace_; }
};

}  // namespace model
}  // namespace tzc
