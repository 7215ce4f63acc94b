// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstdint>

#include "posix/hot.h"

// A bell wakes a thread of another process: a futex word that changes with each ring, and a word that says whether the
// thread sleeps, so that a ring for a thread that is awake costs no system call. Templates, so that the model checker
// runs this very code. `Words` has `bell` and `sleeping`.

namespace tzc {
namespace channel {

/// Either this call sees the sleeper, or the sleeper sees the bell before it falls asleep. The `sleeping`
/// word may be set without need, but never missing while the subscriber sleeps. `wake` gets the word.
template <class Words, class Wake>
TZC_HOT void ring_bell(Words& words, Wake wake) {
  words.bell.fetch_add(1, std::memory_order_seq_cst);
  if (const auto sleeper = words.sleeping.load(std::memory_order_seq_cst); sleeper != 0) wake(sleeper);
}

/// Subscriber: sleeps unless the bell has rung since it was `heard`. `sleep` does so for as long as the word
/// is that value.
template <class Words, class Sleep>
TZC_HOT void wait_for_bell(Words& words, std::uint32_t heard, Sleep sleep) {
  words.sleeping.store(1, std::memory_order_seq_cst);
  sleep(heard);
  words.sleeping.store(0, std::memory_order_relaxed);
}

}  // namespace channel
}  // namespace tzc
