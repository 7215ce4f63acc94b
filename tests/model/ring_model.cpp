// SPDX-License-Identifier: BSD-3-Clause
// usage: ring_model
// Explores every interleaving of one publisher and one subscriber that share a ring and a socket, on the very
// code that the library runs for the ring's words (channel/wire/ring.h): the records come in order, none is missed
// and no thread sleeps forever, wherever one of them dies. Then plants each mistake and demands that it is found.
#include "exploration.h"
#include "ring_words.h"

namespace tzc {
namespace model {
namespace {

constexpr std::size_t subscriber = 0, publisher = 1, threads = 2;
constexpr std::size_t slots = 2;

enum SharedWord : std::size_t {
  socket = ring_word_count,  // the kernel's, as are the next two
  asleep,
  hung_up,
  first_slot,
  word_count = first_slot + slots
};

enum class Mistake {
  none,
  ring_before_socket_is_read,  // the publisher uses the ring while packets wait in the socket
  full_ring,                   // or when all its slots are in use
  ring_looked_at_first,        // the subscriber counts the packets after it has looked into the ring
  deaf_sleep,                  // it sleeps although the bell has rung since it looked
  look_before_bell,            // the publisher asks who sleeps, then rings
};

struct Scenario {
  const char* name;
  unsigned messages;
  unsigned through_socket;  // bit m: message m does not fit a slot
  int deaths;
  Mistake mistake;
};

constexpr Scenario scenarios[] = {
    {"all through the ring", 5, 0, 0, Mistake::none},
    {"the first through the socket", 4, 1 << 1, 0, Mistake::none},
    {"one in between", 5, 1 << 3, 0, Mistake::none},
    {"two in between", 5, 1 << 2 | 1 << 3, 0, Mistake::none},
    {"in turns", 4, 1 << 2 | 1 << 4, 0, Mistake::none},
    {"in turns, one dies", 4, 1 << 1 | 1 << 3, 1, Mistake::none},
};

constexpr Planted<Mistake> mistakes[] = {
    {Mistake::ring_before_socket_is_read, "using the ring while packets wait in the socket"},
    {Mistake::full_ring, "writing into a full ring"},
    {Mistake::ring_looked_at_first, "looking into the ring before counting the packets"},
    {Mistake::deaf_sleep, "falling asleep without looking at the bell"},
    {Mistake::look_before_bell, "asking who sleeps before ringing"},
};

Scenario scenario{};  // of the exploration that runs now: programs are plain functions

/// What a thread remembers between its rounds: counts of its own.
struct Local {
  std::uint8_t messages;
  std::uint8_t through_ring;
  std::uint8_t through_socket;
};

using RingExplorer = Explorer<Local, threads, word_count>;

void ring(Context& context) {
  auto words = words_of(context);
  const auto wake = [&](Word = 1) { ModelAtomic(context, asleep).store(0); };
  if (scenario.mistake != Mistake::look_before_bell) return channel::ring_bell(words, wake);
  const bool sleeps = words.sleeping.load(std::memory_order_seq_cst) != 0;
  words.bell.fetch_add(1, std::memory_order_seq_cst);
  if (sleeps) wake();
}

bool takes(Context& context, const Local& local) {
  auto words = words_of(context);
  const std::size_t room = scenario.mistake == Mistake::full_ring ? slots + 1 : slots;
  const bool all_read = scenario.mistake == Mistake::ring_before_socket_is_read;
  const auto sent = all_read ? static_cast<std::uint32_t>(words.packets_read.load(std::memory_order_acquire))
                             : local.through_socket;
  return channel::ring_takes(words, static_cast<std::uint32_t>(room), local.through_ring, sent);
}

bool publish_round(Context& context, Local& local, std::size_t) {
  auto words = words_of(context);
  const auto message = static_cast<std::uint8_t>(local.messages + 1);
  const bool ends = message > scenario.messages;  // which is one packet more, that need not be counted
  if (!ends && (scenario.through_socket >> message & 1) == 0 && takes(context, local)) {
    ModelAtomic(context, first_slot + local.through_ring % slots).store(message);
    channel::announce_record(words, ++local.through_ring);
  } else {
    if (!ends) ModelAtomic(context, socket).push(message);
    channel::announce_packets(words, ++local.through_socket);
  }
  ring(context);
  local.messages = message;
  return !ends;
}

channel::Source source(Context& context, const Local& local, std::uint32_t& far) {
  auto words = words_of(context);
  const bool ended = ModelAtomic(context, hung_up).load(std::memory_order_acquire) != 0;
  if (scenario.mistake != Mistake::ring_looked_at_first)
    return channel::next_source(words, local.through_ring, local.through_socket, ended, far);
  far = static_cast<std::uint32_t>(words.written.load(std::memory_order_acquire));
  if (far != local.through_ring) return channel::Source::ring;
  const bool more = words.packets.load(std::memory_order_acquire) != local.through_socket || ended;
  return more ? channel::Source::socket : channel::Source::nothing;
}

void receive(Local& local, Word message) {
  if (message != ++local.messages) violated("a message out of order");
}

void sleep(Context& context, std::uint32_t heard) {
  auto words = words_of(context);
  channel::wait_for_bell(words, heard, [&](std::uint32_t value) {
    const bool deaf = scenario.mistake == Mistake::deaf_sleep;
    const std::size_t compared =
        deaf ? std::size_t{asleep} : std::size_t{bell};  // it does not change while this thread is awake
    ModelAtomic(context, asleep).sleep(compared, deaf ? 0 : value);
  });
}

bool subscribe_round(Context& context, Local& local, std::size_t) {
  auto words = words_of(context);
  const std::uint32_t heard = channel::listen(words);
  std::uint32_t far = 0;
  switch (source(context, local, far)) {
    case channel::Source::ring:
      receive(local,
              ModelAtomic(context, first_slot + local.through_ring % slots).load(std::memory_order_relaxed));
      channel::give_back_slot(words, ++local.through_ring);
      return true;
    case channel::Source::socket: {
      const Word message = ModelAtomic(context, socket).pop();
      if (message == 0) return false;
      receive(local, message);
      channel::acknowledge_packet(words, ++local.through_socket);
      return true;
    }
    case channel::Source::nothing:
      sleep(context, heard);
      return true;
  }
  return false;
}

// The system closes the socket, and the subscriber's service thread sees that and rings.
void on_death(RingExplorer::State& state, std::size_t thread) {
  if (thread != publisher) return;
  state.shared[hung_up] = 1;
  ++state.shared[bell];
  state.shared[asleep] = 0;
}

void check_end(const RingExplorer::State& state) {
  const auto& reader = state.thread[subscriber];
  if (reader.dead) return;
  if (!reader.finished) violated("the subscriber sleeps forever");
  if (!state.thread[publisher].dead && reader.local.messages != scenario.messages)
    violated("a message is missing");
}

int run() {
  RingExplorer explorer;
  explorer.programs = {subscribe_round, publish_round};
  explorer.writer = publisher;
  explorer.on_death = on_death;
  explorer.check_end = check_end;
  return Exploration<Scenario, RingExplorer>(explorer, scenario).explore(scenarios, mistakes);
}

}  // namespace
}  // namespace model
}  // namespace tzc

int main() {
  return tzc::model::run();
}
