// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <bitset>
#include <cstddef>
#include <cstdint>
#include <string>

namespace tzc {
namespace model {
namespace weak {

using Word = std::uint64_t;
constexpr std::size_t most_events = 128;
using EventSet = std::bitset<most_events>;

/// What a thread asks of memory.
struct Operation {
  enum Kind { load, await, store, compare_exchange, fetch_add, fetch_or, exchange, lock, fence };
  Kind kind;
  std::size_t location = 0;
  std::memory_order order = std::memory_order_relaxed;
  std::memory_order failure_order = std::memory_order_relaxed;  // of compare_exchange
  Word operand = 0;                                             // what is stored, added, or awaited
  Word expected = 0;                                            // by compare_exchange
  bool atomic = true;                                           // false: as memory that is no std::atomic
};

/// One event of an execution.
struct Event {
  enum Kind { read, write, update, fence };
  Kind kind = write;
  std::size_t thread = 0;
  std::size_t index = 0;  // in its thread
  std::size_t location = 0;
  std::memory_order order = std::memory_order_relaxed;
  bool atomic = true;
  Word value_read = 0;
  Word value_written = 0;
  std::size_t source = 0;  // the event that a read or update reads from
  EventSet before;         // what happens before it
  EventSet releases;       // of a write: what an acquire that reads it synchronizes with

  bool reads() const { return kind == read || kind == update; }
  bool writes() const { return kind == write || kind == update; }
};

inline bool is_acquire(std::memory_order order) {
  return order == std::memory_order_acquire || order == std::memory_order_acq_rel ||
         order == std::memory_order_seq_cst;
}

inline bool is_release(std::memory_order order) {
  return order == std::memory_order_release || order == std::memory_order_acq_rel ||
         order == std::memory_order_seq_cst;
}

inline bool is_sequential(std::memory_order order) {
  return order == std::memory_order_seq_cst;
}

/// Thrown when an execution breaks what the program promises, or the program is outside of the model.
struct Violation {
  std::string what;
};

}  // namespace weak
}  // namespace model
}  // namespace tzc
