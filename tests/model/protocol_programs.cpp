// SPDX-License-Identifier: BSD-3-Clause
#include "protocol_programs.h"

#include <algorithm>

#include "channel/wire/delivery_cursors.h"
#include "segment/ack_word.h"

namespace tzc {
namespace model {

Scenario scenario{};

namespace {

constexpr auto acquire = std::memory_order_acquire;

// ---- publisher ----

class Publisher {
 public:
  Publisher(Context& context, Local& local) : context_(context), local_(local) {}

  void round() {
    notice_hang_ups();
    Sent message{++local_.next_message, slots, slots, 0, 0};
    if (!allocate(message.slot_a, slots)) return;
    if (scenario.blocks_per_message > 1 && !allocate(message.slot_b, message.slot_a)) return;
    fill(message.slot_a, message.message, message.generation_a);
    if (message.slot_b != slots) fill(message.slot_b, message.message, message.generation_b);
    for (std::size_t s = 0; s < subscribers; ++s) send(s, message);
    if (scenario.same_block_twice) send(0, message);
  }

 private:
  ModelAtomic word(std::size_t index) { return ModelAtomic(context_, index); }

  void notice_hang_ups() {
    for (std::size_t s = 0; s < subscribers; ++s) {
      if (!local_.gone[s] && word(hang_up_word(s)).load(acquire))
        local_.gone[s] = 1, local_.in_flight_count[s] = 0;
    }
  }

  bool allocate(std::uint8_t& slot, std::size_t other_than) {
    for (std::size_t i = 0; i < slots; ++i) {
      if (i == other_than || in_use(i)) continue;
      slot = static_cast<std::uint8_t>(i);
      return true;
    }
    if (!scenario.best_effort) return false;
    for (std::size_t i = 0; i < slots; ++i) {
      if (i == other_than) continue;
      for (std::size_t s = 0; s < subscribers; ++s) revoke_block(s, i);
      if (in_use(i)) continue;
      slot = static_cast<std::uint8_t>(i);
      return true;
    }
    return false;
  }

  bool in_use(std::size_t slot) {
    for (std::size_t s = 0; s < subscribers; ++s) {
      if (local_.gone[s] || local_.generation[slot] == 0 ||
          local_.sent_generation[s][slot] != local_.generation[slot])
        continue;
      const Word seen = word(ack_word(s, slot)).load(acquire);
      const bool only_in_flight = scenario.mistake == Mistake::reuse_taken_blocks;
      if (only_in_flight ? segment::unpack(seen).in_flight > 0
                         : !segment::is_idle(seen, local_.generation[slot]))
        return true;
    }
    return false;
  }

  void fill(std::size_t slot, std::uint8_t message, std::uint8_t& generation) {
    generation = ++local_.generation[slot];
    word(payload_word(slot)).store(message);
  }

  void send(std::size_t s, const Sent& message) {
    if (local_.gone[s]) return;
    retire_taken(s, channel::unpack_cursors(word(cursors_word(s)).load(acquire)).taken);
    while (local_.in_flight_count[s] >= scenario.queue_size) revoke_through(s, oldest_sequence(s));
    const Word entry = Word{message.message} | Word{message.slot_a} << 4 | Word{message.slot_b} << 6 |
                       Word{message.generation_a} << 8 | Word{message.generation_b} << 12;
    ++local_.last_sequence[s];
    local_.in_flight[s][local_.in_flight_count[s]++] = message;
    if (scenario.mistake != Mistake::mark_after_send) mark_all(s, message);
    word(socket_word(s)).push(entry);
    if (scenario.mistake == Mistake::mark_after_send) mark_all(s, message);
  }

  void mark_all(std::size_t s, const Sent& message) {
    mark(s, message.slot_a, message.generation_a);
    if (message.slot_b != slots) mark(s, message.slot_b, message.generation_b);
  }

  void mark(std::size_t s, std::size_t slot, std::uint8_t generation) {
    local_.sent_generation[s][slot] = generation;
    ModelAtomic ack = word(ack_word(s, slot));
    if (!segment::mark_in_flight(ack, generation)) violated("a mark failed");
  }

  std::uint8_t oldest_sequence(std::size_t s) const {
    return static_cast<std::uint8_t>(local_.last_sequence[s] - local_.in_flight_count[s] + 1);
  }

  void retire_taken(std::size_t s, std::uint32_t taken) {
    while (local_.in_flight_count[s] > 0 && !channel::is_after(oldest_sequence(s), taken))
      drop_oldest(s, false);
  }

  void revoke_block(std::size_t s, std::size_t slot) {
    if (local_.gone[s]) return;
    retire_taken(s, channel::unpack_cursors(word(cursors_word(s)).load(acquire)).taken);
    std::uint8_t sequence = oldest_sequence(s), found = 0;
    for (std::size_t i = 0; i < local_.in_flight_count[s]; ++i, ++sequence) {
      const Sent& sent = local_.in_flight[s][i];
      if (sent.slot_a == slot || sent.slot_b == slot) found = sequence;
    }
    if (found != 0) revoke_through(s, found);
  }

  void revoke_through(std::size_t s, std::uint8_t sequence) {
    std::uint32_t taken = 0;
    ModelAtomic cursors = word(cursors_word(s));
    channel::try_revoke(cursors, sequence, taken);
    if (scenario.mistake == Mistake::forget_taken_on_revoke) taken = 0;
    while (local_.in_flight_count[s] > 0 && !channel::is_after(oldest_sequence(s), sequence))
      drop_oldest(s, channel::is_after(oldest_sequence(s), taken));
  }

  void drop_oldest(std::size_t s, bool revoked) {
    const Sent sent = local_.in_flight[s][0];
    std::copy(local_.in_flight[s] + 1, local_.in_flight[s] + 4, local_.in_flight[s]);
    local_.in_flight[s][3] = Sent{};
    --local_.in_flight_count[s];
    if (!revoked) return;
    revoke(s, sent.slot_a, sent.generation_a);
    if (sent.slot_b != slots) revoke(s, sent.slot_b, sent.generation_b);
  }

  void revoke(std::size_t s, std::size_t slot, std::uint8_t generation) {
    ModelAtomic ack = word(ack_word(s, slot));
    if (!segment::revoke_in_flight(ack, generation)) violated("a revoked record was not in flight");
  }

  Context& context_;
  Local& local_;
};

// ---- subscriber ----

class Subscriber {
 public:
  Subscriber(Context& context, Local& local, std::size_t self)
      : context_(context), local_(local), self_(self) {}

  /// False at the end of the stream.
  bool round() {
    const Word entry = ModelAtomic(context_, socket_word(self_)).pop();
    if (entry == 0) return false;
    const Sent message{bits(entry, 0, 4), bits(entry, 4, 2), bits(entry, 6, 2), bits(entry, 8, 4),
                       bits(entry, 12, 4)};
    ++local_.received;
    if (!win()) {
      ++local_.lost;
      return true;
    }
    ++local_.delivered;
    hold(message);
    return true;
  }

 private:
  static std::uint8_t bits(Word word, int from, int count) {
    return static_cast<std::uint8_t>(word >> from & ((1u << count) - 1));
  }

  ModelAtomic ack(std::size_t slot) { return ModelAtomic(context_, ack_word(self_, slot)); }

  bool win() {
    ModelAtomic cursors(context_, cursors_word(self_));
    if (scenario.mistake == Mistake::never_follow) return take_without_following(cursors);
    if (scenario.mistake != Mistake::check_before_take) return channel::try_take(cursors, local_.received);
    const channel::DeliveryCursors seen = channel::unpack_cursors(cursors.load(acquire));
    if (!channel::is_after(local_.received, seen.revoked)) return false;
    cursors.store(channel::pack(channel::DeliveryCursors{seen.revoked, local_.received}));
    return true;
  }

  bool take_without_following(ModelAtomic& cursors) {
    for (;;) {
      Word word = cursors.load(acquire);
      const channel::DeliveryCursors seen = channel::unpack_cursors(word);
      if (!channel::is_after(local_.received, seen.revoked)) return false;
      const Word next = channel::pack(channel::DeliveryCursors{seen.revoked, local_.received});
      if (cursors.compare_exchange_weak(word, next, acquire, acquire)) return true;
    }
  }

  void hold(const Sent& message) {
    const bool two = message.slot_b != slots;
    take(message.slot_a, message.generation_a);
    if (two) take(message.slot_b, message.generation_b);
    read(message.slot_a, message.message);
    if (two) read(message.slot_b, message.message);
    release(message.slot_a, message.generation_a);
    if (two) release(message.slot_b, message.generation_b);
  }

  void take(std::size_t slot, std::uint8_t generation) {
    ModelAtomic word = ack(slot);
    if (!segment::take(word, generation)) violated("the winner of a record could not take its blocks");
  }

  void read(std::size_t slot, std::uint8_t message) {
    for (int i = 0; i < 2; ++i) {
      if (ModelAtomic(context_, payload_word(slot)).load(acquire) != message)
        violated("a block changed while a subscriber held it");
    }
  }

  void release(std::size_t slot, std::uint8_t generation) {
    ModelAtomic word = ack(slot);
    if (scenario.mistake == Mistake::ignore_generation)
      generation = static_cast<std::uint8_t>(segment::unpack(word.load(acquire)).generation + 1);
    if (!segment::release(word, generation)) violated("a held block could not be released");
  }

  Context& context_;
  Local& local_;
  const std::size_t self_;
};

}  // namespace

bool publish_round(Context& context, Local& local, std::size_t) {
  if (local.next_message == scenario.messages) return false;
  Publisher(context, local).round();
  return true;
}

bool subscribe_round(Context& context, Local& local, std::size_t thread) {
  return Subscriber(context, local, thread).round();
}

void hang_up(ProtocolExplorer::State& state, std::size_t thread) {
  if (thread != publisher) state.shared[hang_up_word(thread)] = 1;
}

// Shortly before a cursor is moved along; where that is forgotten, shortly before it can no longer be compared.
ProtocolExplorer::State start_of(const Scenario& scenario) {
  const std::uint32_t gap =
      scenario.mistake == Mistake::never_follow ? 0x7ffffffe : channel::max_cursor_gap - 1;
  channel::DeliveryCursors cursors{0, 0};
  if (scenario.behind == Behind::revoked) cursors.revoked -= gap;
  if (scenario.behind == Behind::taken) cursors.taken -= gap;
  ProtocolExplorer::State state{};
  for (std::size_t s = 0; s < subscribers; ++s) state.shared[cursors_word(s)] = channel::pack(cursors);
  return state;
}

// When all is over: every record was either delivered or is known to be lost, and no living subscriber's
// words keep a block that is neither in flight nor held.
void check_end(const ProtocolExplorer::State& state) {
  const auto& out = state.thread[publisher];
  if (!out.finished) return;
  for (std::size_t s = 0; s < subscribers; ++s) {
    const auto& in = state.thread[s];
    if (in.dead || out.local.gone[s]) continue;
    if (!in.finished) violated("a subscriber waits for ever");
    if (in.local.received != out.local.last_sequence[s]) violated("a record got lost on the way");
    if (in.local.delivered + in.local.lost != in.local.received)
      violated("a record was neither delivered nor lost");
    for (std::size_t slot = 0; slot < slots; ++slot) {
      const segment::AckCounts counts = segment::unpack(state.shared[ack_word(s, slot)]);
      if (counts.in_flight != 0 || counts.taken != 0) violated("a block stays in use for ever");
    }
  }
}

}  // namespace model
}  // namespace tzc
