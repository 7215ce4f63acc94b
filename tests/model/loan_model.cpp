// SPDX-License-Identifier: BSD-3-Clause
// usage: loan_model
// Explores every interleaving of a publisher that lends sockets, the subscriber's thread that hears of them on the trunk, and
// the one that reads, on the very code that the library runs for the ring's words (channel/wire/ring.h): the records come in
// order whichever way they take, none is missed, no thread sleeps forever, and at most two loans are there at once, wherever
// the publisher dies. Then plants each mistake and demands that it is found. Lending and giving back are restated here, as
// the locked steps of channel/connect/sending_socket.h and channel/connect/lent_sockets.h that they are.
#include "exploration.h"
#include "ring_words.h"

namespace tzc {
namespace model {
namespace {

constexpr std::size_t reader = 0, publisher = 1, trunk_thread = 2, threads = 3;
constexpr std::size_t slots = 2;
constexpr std::size_t sockets = 3;  // one more than may be open at once

enum SharedWord : std::size_t {
  asleep = ring_word_count,
  ended,
  lent,   // the subscriber's: current loan, and the next one in the second byte
  trunk,  // the kernel's, as are the next ones
  held,   // the loan that the publisher has open
  rest_of_time,
  first_socket,
  first_slot = first_socket + sockets,
  word_count = first_slot + slots
};

constexpr Word end_of_socket = 0xffff;  // behind its last packet
constexpr Word end_of_all = 0xffff;     // on the trunk

enum class Mistake {
  none,
  given_up_unread,  // the publisher gives a loan up while packets wait in it
  end_not_counted,  // or does not count its end
  silent_loan,      // the subscriber does not look again when a loan has come
  end_asked_last,   // it looks for a loan, then asks whether the end has come
  end_before_loan,  // the end overtakes a loan on the trunk
};

struct Scenario {
  const char* name;
  unsigned messages;
  unsigned through_socket;  // bit m: message m does not fit a slot
  unsigned rests_before;    // bit m: the publisher looks before message m whether the loan is still needed
  bool ends;                // or the publisher stays, and has nothing more to say
  int deaths;
  Mistake mistake;
};

constexpr Scenario scenarios[] = {
    {"one loan", 2, 1 << 2, 0, true, 0, Mistake::none},
    {"a loan at rest", 2, 1 << 1, 1 << 2, true, 0, Mistake::none},
    {"two loans", 2, 1 << 1 | 1 << 2, 1 << 2, true, 0, Mistake::none},
    {"two loans, no end", 2, 1 << 1 | 1 << 2, 1 << 2, false, 0, Mistake::none},
    {"two loans, the publisher dies", 2, 1 << 1 | 1 << 2, 1 << 2, true, 1, Mistake::none},
    {"the ring between two loans", 3, 1 << 1 | 1 << 3, 1 << 2, true, 0, Mistake::none},
    {"three loans", 3, 1 << 1 | 1 << 2 | 1 << 3, 1 << 2 | 1 << 3, true, 0, Mistake::none},
};

constexpr Planted<Mistake> mistakes[] = {
    {Mistake::given_up_unread, "giving up a loan that is not read"},
    {Mistake::end_not_counted, "not counting the end of a loan"},
    {Mistake::silent_loan, "not looking again when a loan has come"},
    {Mistake::end_asked_last, "asking for the end after looking for a loan"},
    {Mistake::end_before_loan, "telling the end before the loan"},
};

Scenario scenario{};  // of the exploration that runs now: programs are plain functions

/// What a thread remembers between its rounds: counts of its own.
struct Local {
  std::uint8_t messages;
  std::uint8_t through_ring;
  std::uint8_t packets;
  std::uint8_t loans;  // publisher: that it has made
  bool lends;          // the last one is open
};

using LoanExplorer = Explorer<Local, threads, word_count>;

ModelAtomic word(Context& context, std::size_t index) {
  return ModelAtomic(context, index);
}

ModelAtomic socket_of(Context& context, Word loan) {
  return word(context, first_socket + loan % sockets);
}

void ring(Context& context) {
  auto words = words_of(context);
  channel::ring_bell(words, [&](Word = 1) { word(context, asleep).store(0); });
}

// The publisher's.

void announce_packet(Context& context, Local& local) {
  auto words = words_of(context);
  channel::announce_packets(words, ++local.packets);
  ring(context);
}

void give_up(Context& context, Local& local) {
  socket_of(context, local.loans).push(end_of_socket);
  word(context, held).store(0);
  local.lends = false;
}

void count_end_of_loan(Context& context, Local& local) {
  if (scenario.mistake != Mistake::end_not_counted) announce_packet(context, local);
}

void rest(Context& context, Local& local) {
  if (!local.lends) return;
  const Word all_read = word(context, packets_read).load(std::memory_order_acquire);
  if (all_read != local.packets && scenario.mistake != Mistake::given_up_unread) return;
  give_up(context, local);
  count_end_of_loan(context, local);
}

void end(Context& context, Local& local) {
  const bool counts = local.lends;
  if (counts) give_up(context, local);
  if (scenario.mistake != Mistake::end_before_loan) word(context, trunk).push(end_of_all);
  if (counts) count_end_of_loan(context, local);
}

void stay(Context& context) {
  for (;;) word(context, rest_of_time).lock();
}

void lend(Context& context, Local& local, Word message) {
  local.lends = true;
  word(context, held).store(++local.loans);
  if (scenario.mistake == Mistake::end_before_loan && message == scenario.messages)
    word(context, trunk).push(end_of_all);
  word(context, trunk).push(local.loans);
}

void send_through_socket(Context& context, Local& local, Word message) {
  if (!local.lends) lend(context, local, message);
  socket_of(context, local.loans).push(message);
  announce_packet(context, local);
}

bool publish_round(Context& context, Local& local, std::size_t) {
  auto words = words_of(context);
  const auto message = static_cast<std::uint8_t>(local.messages + 1);
  if (message > scenario.messages) {
    scenario.ends ? end(context, local) : stay(context);
    return false;
  }
  if ((scenario.rests_before >> message & 1) != 0) rest(context, local);
  const bool fits = (scenario.through_socket >> message & 1) == 0;
  if (fits && channel::ring_takes(words, slots, local.through_ring, local.packets)) {
    word(context, first_slot + local.through_ring % slots).store(message);
    channel::announce_record(words, ++local.through_ring);
    ring(context);
  } else {
    send_through_socket(context, local, message);
  }
  local.messages = message;
  return true;
}

// The subscriber's thread that hears the trunk.

void take_loan(Context& context, Word loan) {
  ModelAtomic both = word(context, lent);
  for (Word seen = both.load(std::memory_order_acquire);;) {
    if (seen >> 8 != 0) violated("a third loan");
    const Word with = seen == 0 ? loan : seen | loan << 8;
    if (both.compare_exchange_weak(seen, with, std::memory_order_acq_rel, std::memory_order_acquire)) return;
  }
}

bool hear_round(Context& context, Local&, std::size_t) {
  const Word heard = word(context, trunk).pop();
  const bool is_over = heard == 0 || heard == end_of_all;
  if (is_over)
    word(context, ended).store(1);
  else
    take_loan(context, heard);
  if (is_over || scenario.mistake != Mistake::silent_loan) ring(context);
  return !is_over;
}

// The one that reads.

void receive(Local& local, Word message) {
  if (message != ++local.messages) violated("a message out of order");
}

bool has_ended(Context& context) {
  return word(context, ended).load(std::memory_order_acquire) != 0;
}

enum class Read { something, nothing, closed };

void give_back(Context& context) {
  ModelAtomic both = word(context, lent);
  Word seen = both.load(std::memory_order_acquire);
  while (!both.compare_exchange_weak(seen, seen >> 8, std::memory_order_acq_rel, std::memory_order_acquire)) {
  }
}

Read read_socket(Context& context, Local& local) {
  auto words = words_of(context);
  bool is_over = has_ended(context);
  const Word current = word(context, lent).load(std::memory_order_acquire) & 0xff;
  if (scenario.mistake == Mistake::end_asked_last) is_over = has_ended(context);
  if (current == 0) return is_over ? Read::closed : Read::nothing;
  if (socket_of(context, current).load(std::memory_order_acquire) == 0) return Read::nothing;
  const Word packet = socket_of(context, current).pop();
  if (packet == end_of_socket)
    give_back(context);
  else
    receive(local, packet);
  channel::acknowledge_packet(words, ++local.packets);
  return Read::something;
}

bool read_round(Context& context, Local& local, std::size_t) {
  auto words = words_of(context);
  const std::uint32_t heard = channel::listen(words);
  std::uint32_t far = 0;
  Read result = Read::nothing;
  switch (channel::next_source(words, local.through_ring, local.packets, has_ended(context), far)) {
    case channel::Source::ring:
      receive(local, word(context, first_slot + local.through_ring % slots).load(std::memory_order_relaxed));
      channel::give_back_slot(words, ++local.through_ring);
      return true;
    case channel::Source::socket:
      result = read_socket(context, local);
      break;
    case channel::Source::nothing:
      break;
  }
  if (result == Read::nothing)
    channel::wait_for_bell(words, heard,
                           [&](std::uint32_t value) { word(context, asleep).sleep(bell, value); });
  return result != Read::closed;
}

// The system closes the socket: what is in it may still be read. (Its end may be there already.)
void on_death(LoanExplorer::State& state, std::size_t) {
  if (state.shared[held] == 0) return;
  Word& queue = state.shared[first_socket + state.shared[held] % sockets];
  int shift = 0;
  while ((queue >> shift & 0xffff) != 0) shift += 16;
  queue |= end_of_socket << shift;
}

void check_end(const LoanExplorer::State& state) {
  const auto& last = state.thread[reader];
  if (last.dead || state.thread[trunk_thread].dead) return;
  const bool lives = !state.thread[publisher].dead;
  if (!last.finished && (scenario.ends || !lives)) violated("the subscriber sleeps forever");
  if (lives && last.local.messages != scenario.messages) violated("a message is missing");
}

int run() {
  LoanExplorer explorer;
  explorer.programs = {read_round, publish_round, hear_round};
  explorer.writer = publisher;
  explorer.on_death = on_death;
  explorer.check_end = check_end;
  return Exploration<Scenario, LoanExplorer>(explorer, scenario).explore(scenarios, mistakes);
}

}  // namespace
}  // namespace model
}  // namespace tzc

int main() {
  return tzc::model::run();
}
