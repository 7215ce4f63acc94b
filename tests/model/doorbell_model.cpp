// SPDX-License-Identifier: BSD-3-Clause
// usage: doorbell_model
// Explores every interleaving of two publishers and the one thread that reads both of their rings, on the very code that
// the library runs for a doorbell's words (channel/wait/doorbell.h, segment/release_hints.h): no record is left in a ring
// while the reader sleeps. Then plants each mistake and demands that it is found.
#include "channel/wait/doorbell.h"
#include "exploration.h"
#include "explorer.h"

namespace tzc {
namespace model {
namespace {

constexpr std::size_t reader = 2, threads = 3;
constexpr std::uint32_t number_of[] = {1, 2};  // of each publisher; both in leaf 0

enum SharedWord : std::size_t { bell, sleeping, groups, leaf, asleep, first_ring, second_ring, word_count };

enum class Mistake {
  none,
  bit_before_record,  // the reader may look too early, and never again
  bell_before_bit,    // the reader may go back to sleep before it sees the bit
  bits_emptied_last,  // the reader looks into the ring, then empties the bits
  bell_heard_last,    // the reader listens after it has looked
  look_before_bell,   // the publisher asks who sleeps, then rings
};

struct Scenario {
  const char* name;
  unsigned records[2];  // of each publisher
  int deaths;
  Mistake mistake;
};

constexpr Scenario scenarios[] = {{"a record each", {1, 1}, 0, Mistake::none},
                                  {"two and one", {2, 1}, 0, Mistake::none}};

constexpr Planted<Mistake> mistakes[] = {
    {Mistake::bit_before_record, "setting the bit before the record is written"},
    {Mistake::bell_before_bit, "ringing before the bit is set"},
    {Mistake::bits_emptied_last, "looking into the ring before emptying the bits"},
    {Mistake::bell_heard_last, "listening to the bell after looking"},
    {Mistake::look_before_bell, "asking who sleeps before ringing"},
};

Scenario scenario{};

struct Local {
  std::uint8_t written;
  std::uint8_t read[2];
};

using DoorbellExplorer = Explorer<Local, threads, word_count>;

ModelAtomic word(Context& context, std::size_t index) {
  return ModelAtomic(context, index);
}

channel::DoorbellWords<ModelAtomic, ModelAtomic> words_of(Context& context) {
  return {word(context, bell), word(context, sleeping), word(context, groups), word(context, leaf)};
}

void ring(Context& context, std::uint32_t number) {
  auto words = words_of(context);
  const auto wake = [&](Word = 1) { word(context, asleep).store(0); };
  switch (scenario.mistake) {
    case Mistake::bell_before_bit:
      channel::ring_bell(words, wake);
      return segment::add_hint(words.groups, words.leaf, number, channel::doorbell_numbers);
    case Mistake::look_before_bell: {
      segment::add_hint(words.groups, words.leaf, number, channel::doorbell_numbers);
      const bool sleeps = words.sleeping.load(std::memory_order_seq_cst) != 0;
      words.bell.fetch_add(1, std::memory_order_seq_cst);
      return sleeps ? wake() : void();
    }
    default:
      return channel::ring_doorbell(words, number, wake);
  }
}

bool publish_round(Context& context, Local& local, std::size_t thread) {
  const auto record = static_cast<std::uint8_t>(local.written + 1);
  if (scenario.mistake == Mistake::bit_before_record) ring(context, number_of[thread]);
  word(context, first_ring + thread).store(record, std::memory_order_release);
  if (scenario.mistake != Mistake::bit_before_record) ring(context, number_of[thread]);
  local.written = record;
  return record < scenario.records[thread];
}

void look_into(Context& context, Local& local, std::size_t publisher) {
  local.read[publisher] =
      static_cast<std::uint8_t>(word(context, first_ring + publisher).load(std::memory_order_acquire));
}

bool look_where_bits_are(Context& context, Local& local) {
  segment::HintReader hints(channel::doorbell_numbers);
  ModelAtomic set = word(context, groups);
  bool found = false;
  for (;;) {
    const std::uint32_t number =
        hints.next(set, [&context](std::uint32_t index) { return word(context, leaf + index); });
    if (number == segment::no_slot) return found;
    found = true;
    look_into(context, local, number == number_of[0] ? 0 : 1);
  }
}

bool look_wrongly(Context& context, Local& local) {
  const Word bits = word(context, leaf).load(std::memory_order_acquire);
  for (std::size_t i = 0; i < 2; ++i)
    if ((bits >> number_of[i] & 1) != 0) look_into(context, local, i);
  word(context, groups).exchange(0, std::memory_order_acquire);
  word(context, leaf).exchange(0, std::memory_order_acquire);
  return bits != 0;
}

Word listen(Context& context) {
  return word(context, bell).load(std::memory_order_acquire);
}

bool read_round(Context& context, Local& local, std::size_t) {
  Word heard = listen(context);
  const bool found = scenario.mistake == Mistake::bits_emptied_last ? look_wrongly(context, local)
                                                                    : look_where_bits_are(context, local);
  if (local.read[0] == scenario.records[0] && local.read[1] == scenario.records[1]) return false;
  if (scenario.mistake == Mistake::bell_heard_last) heard = listen(context);
  if (found) return true;
  auto words = words_of(context);
  channel::wait_for_bell(words, static_cast<std::uint32_t>(heard),
                         [&](std::uint32_t value) { word(context, asleep).sleep(bell, value); });
  return true;
}

void check_end(const DoorbellExplorer::State& state) {
  if (!state.thread[reader].finished)
    throw Violation{"a record lies in a ring, and the reader sleeps forever"};
}

int run() {
  DoorbellExplorer explorer;
  explorer.programs = {publish_round, publish_round, read_round};
  explorer.check_end = check_end;
  return Exploration<Scenario, DoorbellExplorer>(explorer, scenario).explore(scenarios, mistakes);
}

}  // namespace
}  // namespace model
}  // namespace tzc

int main() {
  return tzc::model::run();
}
