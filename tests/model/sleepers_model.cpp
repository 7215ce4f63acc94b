// SPDX-License-Identifier: BSD-3-Clause
// usage: sleepers_model
// Explores every interleaving of a publisher, a thread that has work for a guest, the guest, and the reader in whose place it
// reads, on the very code that the library runs for who is woken (channel/wait/sleepers.h, channel/wait/doorbell.h): no record is left,
// and no work of the guest's, while both sleep; also when the guest goes. No sleep ends by itself here. Then plants each mistake
// and demands that it is found.
#include "channel/wait/sleepers.h"
#include "exploration.h"
#include "explorer.h"

namespace tzc {
namespace model {
namespace {

using channel::Sleeper;

constexpr std::size_t reader = 0, guest = 1, publisher = 2, worker = 3, threads = 4;
constexpr std::uint32_t number = 1;  // of the connection; in leaf 0

enum SharedWord : std::size_t {
  bell,
  sleeping,
  groups,
  leaf,
  ring,          // records in it
  read_records,  // out of it
  asleep,
  asleep_mutex,
  turn_mutex,
  work,               // for the guest
  reader_is_waiting,  // the kernel's, as is the next one
  guest_is_waiting,
  word_count
};

enum class Mistake {
  none,
  reads_then_tells,   // the guest reads what has come, then tells publishers that it is awake
  nobody_is_told,     // the guest that wakes up does not name the reader
  asks_before_sleep,  // the guest asks for work, then says that it sleeps
  silent_work,        // the worker wakes the guest without ringing
  no_lock,            // both say at the same time who sleeps
};

struct Scenario {
  const char* name;
  unsigned records;
  bool has_work;
  unsigned visits;  // of the guest, until it goes for good; 0: it stays
  Mistake mistake;
  int deaths = 0;
};

constexpr Scenario scenarios[] = {
    {"work", 0, true, 0, Mistake::none},
    {"a record", 1, false, 0, Mistake::none},
    {"a record, the guest goes", 1, false, 1, Mistake::none},
    {"a record, it comes twice", 1, false, 2, Mistake::none},
    {"a record and work, the guest goes", 1, true, 1, Mistake::none},
    {"two records", 2, false, 0, Mistake::none},
};

constexpr Planted<Mistake> mistakes[] = {
    {Mistake::reads_then_tells, "reading before telling who is awake"},
    {Mistake::nobody_is_told, "a guest that wakes up and names nobody"},
    {Mistake::asks_before_sleep, "asking for work before saying that it sleeps"},
    {Mistake::silent_work, "waking without ringing"},
    {Mistake::no_lock, "saying who sleeps without the lock"},
};

Scenario scenario{};

/// What a thread remembers between its rounds.
struct Local {
  std::uint32_t heard;
  std::uint8_t records;  // publisher: that it has written
  std::uint8_t visits;
  bool sleeps;
};

using SleepersExplorer = Explorer<Local, threads, word_count>;

ModelAtomic word(Context& context, std::size_t index) {
  return ModelAtomic(context, index);
}

void wake(Context& context, Word who) {
  if (who != 0) word(context, who == channel::guest_sleeps ? guest_is_waiting : reader_is_waiting).store(0);
}

channel::SleeperWords<ModelAtomic> words_of(Context& context) {
  return {word(context, bell), word(context, sleeping), word(context, asleep)};
}

void set_asleep(Context& context, Sleeper who, bool sleeps) {
  auto words = words_of(context);
  const bool locks = scenario.mistake != Mistake::no_lock;
  if (locks) word(context, asleep_mutex).lock();
  channel::set_asleep(words, who, sleeps);
  if (scenario.mistake == Mistake::nobody_is_told && who == channel::guest_sleeps && !sleeps)
    word(context, sleeping).store(0);
  if (locks) word(context, asleep_mutex).store(0);
}

bool has_work(Context& context) {
  return word(context, work).load(std::memory_order_seq_cst) != 0;
}

void sleep(Context& context, Sleeper who, std::uint32_t heard) {
  const bool is_guest = who == channel::guest_sleeps;
  const bool early = is_guest && scenario.mistake == Mistake::asks_before_sleep && has_work(context);
  set_asleep(context, who, true);
  const bool wanted = scenario.mistake == Mistake::asks_before_sleep ? early : is_guest && has_work(context);
  if (!wanted) word(context, is_guest ? guest_is_waiting : reader_is_waiting).sleep(bell, heard);
}

// One thread's turn to read (Receiver::read_round).
std::uint32_t read_all(Context& context) {
  word(context, turn_mutex).lock();
  const auto heard = static_cast<std::uint32_t>(word(context, bell).load(std::memory_order_acquire));
  segment::HintReader hints(channel::doorbell_numbers);
  ModelAtomic set = word(context, groups);
  const auto leaf_of = [&context](std::uint32_t index) { return word(context, leaf + index); };
  while (hints.next(set, leaf_of) != segment::no_slot)
    word(context, read_records).store(word(context, ring).load(std::memory_order_acquire));
  word(context, turn_mutex).store(0);
  return heard;
}

bool reader_round(Context& context, Local& local, std::size_t) {
  if (local.sleeps)
    set_asleep(context, channel::reader_sleeps, false);
  else {
    local.heard = read_all(context);
    sleep(context, channel::reader_sleeps, local.heard);
  }
  local.sleeps = !local.sleeps;
  return true;
}

// Receiver::host, once and again, and what the guest does between its visits.
bool guest_round(Context& context, Local& local, std::size_t) {
  if (local.sleeps) {
    if (scenario.mistake == Mistake::reads_then_tells) local.heard = read_all(context);
    set_asleep(context, channel::guest_sleeps, false);
    local.sleeps = false;
    if (scenario.mistake == Mistake::reads_then_tells && scenario.visits != 0) return false;
    return true;
  }
  local.heard = read_all(context);
  if (has_work(context)) word(context, work).store(0);
  if (scenario.visits != 0 && local.visits++ == scenario.visits) return false;
  sleep(context, channel::guest_sleeps, local.heard);
  local.sleeps = true;
  return true;
}

bool publisher_round(Context& context, Local& local, std::size_t) {
  if (local.records == scenario.records) return false;
  word(context, ring).store(++local.records, std::memory_order_release);
  channel::DoorbellWords<ModelAtomic, ModelAtomic> words{word(context, bell), word(context, sleeping),
                                                         word(context, groups), word(context, leaf)};
  channel::ring_doorbell(words, number, [&](Word who) { wake(context, who); });
  return true;
}

bool worker_round(Context& context, Local&, std::size_t) {
  if (!scenario.has_work) return false;
  word(context, work).store(1);
  auto words = words_of(context);
  const auto wake_guest = [&] { wake(context, channel::guest_sleeps); };
  if (scenario.mistake == Mistake::silent_work)
    wake_guest();
  else
    channel::wake_if_asleep(words, channel::guest_sleeps, wake_guest);
  return false;
}

void check_end(const SleepersExplorer::State& state) {
  if (state.shared[read_records] != scenario.records) violated("a record is left, and all sleep");
  if (state.shared[work] != 0 && !state.thread[guest].finished)
    violated("work is left, and the guest sleeps");
}

int run() {
  SleepersExplorer explorer;
  explorer.programs = {reader_round, guest_round, publisher_round, worker_round};
  explorer.check_end = check_end;
  return Exploration<Scenario, SleepersExplorer>(explorer, scenario).explore(scenarios, mistakes);
}

}  // namespace
}  // namespace model
}  // namespace tzc

int main() {
  return tzc::model::run();
}
