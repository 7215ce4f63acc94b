// SPDX-License-Identifier: BSD-3-Clause
// usage: handle_model
// Explores every interleaving of a publisher's threads around one block while a subscriber leaves, on the very code
// that the library runs for the count of handles (segment/handle_count.h) and for the acknowledgement words: the
// service thread takes the record back (revive, revoke the mark), sends it to another subscriber and drops its
// handle; another thread finds the block by its address; the allocator wants to free it meanwhile. Then plants each
// mistake and demands that it is found.
#include "exploration.h"
#include "explorer.h"
#include "segment/ack_word.h"
#include "segment/handle_count.h"

namespace tzc {
namespace model {
namespace {

constexpr std::size_t allocator = 0, service = 1, finder = 2, threads = 3;
constexpr Word generation = 7;  // of the block that is in flight at the start
constexpr Word content = 41, other_content = 99;
constexpr auto acquire = std::memory_order_acquire;

enum SharedWord : std::size_t {
  live_lock,
  live_generation,
  handles,
  first_ack,
  second_ack,
  payload,
  word_count
};

enum class Mistake {
  none,
  no_lock,              // the allocator looks at the handles, then at the words
  no_lock_words_first,  // or the other way round
  revoke_first,         // the service thread revokes the mark, then takes the record back
  find_unlocked,        // find makes a handle of a block that may be free by now
};

struct Scenario {
  const char* name;
  bool sent_again;  // to another subscriber, which takes and releases it
  bool found;       // by its address, meanwhile
  int deaths;
  Mistake mistake;
};

constexpr Scenario scenarios[] = {
    {"taken back", false, false, 0, Mistake::none},
    {"taken back, found meanwhile", false, true, 0, Mistake::none},
    {"taken back, sent again", true, false, 0, Mistake::none},
    {"taken back, sent again, found", true, true, 0, Mistake::none},
};

constexpr Planted<Mistake> mistakes[] = {
    {Mistake::no_lock, "looking at handles, then at words, while handles are made"},
    {Mistake::no_lock_words_first, "looking at words, then at handles, while handles are made"},
    {Mistake::revoke_first, "revoking the mark before the record is taken back"},
    {Mistake::find_unlocked, "making a handle of what was found, without the lock"},
};

Scenario scenario{};  // of the exploration that runs now: programs are plain functions

struct Local {
  std::uint8_t rounds;
  std::uint8_t freed;
};

using HandleExplorer = Explorer<Local, threads, word_count>;

ModelAtomic word(Context& context, SharedWord index) {
  return ModelAtomic(context, index);
}

bool holds(Context& context, SharedWord ack) {
  return !segment::is_idle(word(context, ack).load(acquire), generation);
}

bool looks_unused(Context& context) {
  ModelAtomic count = word(context, handles);
  const auto held = [&context] { return holds(context, first_ack) || holds(context, second_ack); };
  if (scenario.mistake != Mistake::no_lock_words_first) return !segment::is_in_use(count, held);
  return !held() && count.load(acquire) == 0;
}

// Three looks: more find nothing more.
bool allocate_round(Context& context, Local& local, std::size_t) {
  const bool locks = scenario.mistake != Mistake::no_lock && scenario.mistake != Mistake::no_lock_words_first;
  if (locks) word(context, live_lock).lock();
  const bool freed = looks_unused(context);
  if (freed) word(context, live_generation).store(0);
  if (locks) word(context, live_lock).store(0);
  if (freed) word(context, payload).store(other_content);
  local.freed = freed ? 1 : 0;
  return !freed && ++local.rounds < 3;
}

void read(Context& context) {
  for (int i = 0; i < 2; ++i) {
    if (word(context, payload).load(acquire) != content) violated("a block changed while it was in use");
  }
}

void drop_handle(Context& context) {
  word(context, handles).fetch_add(~Word{0}, std::memory_order_acq_rel);
}

bool revive(Context& context) {
  word(context, live_lock).lock();
  const bool lives = word(context, live_generation).load(acquire) == generation;
  ModelAtomic count = word(context, handles);
  if (lives) segment::add_handle(count);
  word(context, live_lock).store(0);
  return lives;
}

void revoke(Context& context, SharedWord ack) {
  ModelAtomic counts = word(context, ack);
  if (!segment::revoke_in_flight(counts, generation)) violated("a mark was not in flight");
}

void send_again(Context& context) {
  ModelAtomic ack = word(context, second_ack);
  if (!segment::mark_in_flight(ack, generation)) violated("a mark failed");
  drop_handle(context);
  if (!segment::take(ack, generation)) violated("a marked block could not be taken");
  read(context);
  if (!segment::release(ack, generation)) violated("a taken block could not be released");
}

bool leave_round(Context& context, Local&, std::size_t) {
  if (scenario.mistake == Mistake::revoke_first) revoke(context, first_ack);
  if (!revive(context)) violated("a block in flight is no more");
  if (scenario.mistake != Mistake::revoke_first) revoke(context, first_ack);
  read(context);
  scenario.sent_again ? send_again(context) : drop_handle(context);
  return false;
}

bool find_round(Context& context, Local&, std::size_t) {
  if (!scenario.found) return false;
  const bool unlocked = scenario.mistake == Mistake::find_unlocked;
  if (!unlocked) word(context, live_lock).lock();
  const bool lives = word(context, live_generation).load(acquire) == generation;
  ModelAtomic count = word(context, handles);
  bool found = false;
  if (lives) found = unlocked ? (segment::add_handle(count), true) : segment::add_handle_if_any(count);
  if (!unlocked) word(context, live_lock).store(0);
  if (!found) return false;
  if (word(context, live_generation).load(acquire) != generation) violated("a freed block was found");
  read(context);
  drop_handle(context);
  return false;
}

void check_end(const HandleExplorer::State& state) {
  for (const SharedWord ack : {first_ack, second_ack}) {
    if (!segment::is_idle(state.shared[ack], generation)) violated("a mark stays for ever");
  }
  if (state.shared[handles] != 0) violated("a handle stays for ever");
  if (state.shared[live_lock] != 0) violated("a lock stays for ever");
}

int run() {
  HandleExplorer explorer;
  explorer.programs = {allocate_round, leave_round, find_round};
  explorer.check_end = check_end;
  HandleExplorer::State start{};
  start.shared[live_generation] = generation;
  start.shared[first_ack] = segment::pack({static_cast<std::uint32_t>(generation), 1, 0});
  start.shared[payload] = content;
  return Exploration<Scenario, HandleExplorer>(explorer, scenario, start).explore(scenarios, mistakes);
}

}  // namespace
}  // namespace model
}  // namespace tzc

int main() {
  return tzc::model::run();
}
