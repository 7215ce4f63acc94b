// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "explorer.h"

// The lifetime protocol of one publisher and two subscribers, on the very code that the library runs for
// every shared word: segment/ack_word.h and channel/wire/delivery_cursors.h. What is modelled around it: allocate (reclaim,
// revoke for best_effort), publish (queue bound, mark, write), receive, take, read twice, release, the death
// of any thread at any step and the hang-up that follows.

namespace tzc {
namespace model {

constexpr std::size_t subscribers = 2;
constexpr std::size_t publisher = 2;  // threads 0 and 1 subscribe
constexpr std::size_t slots = 2;

// Shared words.
constexpr std::size_t cursors_word(std::size_t subscriber) {
  return subscriber;
}
constexpr std::size_t ack_word(std::size_t subscriber, std::size_t slot) {
  return 2 + subscriber * slots + slot;
}
constexpr std::size_t payload_word(std::size_t slot) {
  return 6 + slot;
}
constexpr std::size_t socket_word(std::size_t subscriber) {
  return 8 + subscriber;
}
constexpr std::size_t hang_up_word(std::size_t subscriber) {
  return 10 + subscriber;
}
constexpr std::size_t word_count = 12;

/// Deliberate mistakes, each of which the exploration must find.
enum class Mistake {
  none,
  mark_after_send,         // the subscriber may know a block that is not counted yet
  check_before_take,       // the subscriber looks at the cursors, then takes: not in one step
  forget_taken_on_revoke,  // the publisher revokes a range without looking who won its beginning
  reuse_taken_blocks,      // allocate looks only at what is in flight
  ignore_generation,       // a release hits whatever lives in the slot now
  never_follow,            // a cursor that its side does not move falls back by 2^31 records
};

enum class Behind { none, revoked, taken };

struct Scenario {
  const char* name;
  unsigned messages;
  unsigned blocks_per_message;
  unsigned queue_size;
  bool best_effort;
  bool same_block_twice;  // the first subscriber gets every message twice
  int deaths;
  Mistake mistake;
  Behind behind = Behind::none;  // the cursor that has not moved for long when it starts
};

extern Scenario scenario;  // of the exploration that runs now: programs are plain functions

struct Sent {
  std::uint8_t message, slot_a, slot_b;
  std::uint8_t generation_a, generation_b;
};

/// What a thread remembers between its rounds. Zero-initialized plain data: states are compared byte by byte.
struct Local {
  // publisher
  std::uint8_t next_message;
  std::uint8_t generation[slots];
  std::uint8_t sent_generation[subscribers][slots];
  std::uint8_t gone[subscribers];
  std::uint8_t in_flight_count[subscribers];
  std::uint8_t last_sequence[subscribers];
  Sent in_flight[subscribers][4];
  // subscriber
  std::uint8_t received;
  std::uint8_t delivered;
  std::uint8_t lost;
};

using ProtocolExplorer = Explorer<Local, subscribers + 1, word_count>;

bool publish_round(Context& context, Local& local, std::size_t thread);
bool subscribe_round(Context& context, Local& local, std::size_t thread);
void hang_up(ProtocolExplorer::State& state, std::size_t thread);
/// Where the cursors stand when a scenario begins.
ProtocolExplorer::State start_of(const Scenario& scenario);
void check_end(const ProtocolExplorer::State& state);

}  // namespace model
}  // namespace tzc
