// SPDX-License-Identifier: BSD-3-Clause
// usage: hint_model
// Explores every interleaving of two threads that release slots and the allocator that reads the hints, on the very
// code that the library runs (segment/release_hints.h): what was released is found by the last look at the latest.
#include "exploration.h"
#include "explorer.h"
#include "segment/release_hints.h"

namespace tzc {
namespace model {
namespace {

constexpr std::size_t allocator = 2, threads = 3;
constexpr std::uint32_t slots = 64 * 3;        // three leaves, each a group of its own
constexpr std::uint32_t slot_of[] = {65, 70};  // of each releasing thread; both in leaf 1

enum SharedWord : std::size_t { top, leaf_0, leaf_1, leaf_2, first_released, second_released, word_count };

enum class Mistake {
  none,
  hint_before_release,  // the allocator may look too early, and never again
  group_before_leaf,    // the allocator may empty the leaf too early
  leaf_before_group,    // the allocator empties the leaf, then the group
};

struct Scenario {
  const char* name;
  int deaths;
  Mistake mistake;
};

constexpr Scenario scenarios[] = {{"two release", 0, Mistake::none}};

constexpr Planted<Mistake> mistakes[] = {
    {Mistake::hint_before_release, "hinting before the release"},
    {Mistake::group_before_leaf, "adding the group before the leaf"},
    {Mistake::leaf_before_group, "emptying the leaf before its group"},
};

Scenario scenario{};

struct Local {
  std::uint8_t found[2];
  std::uint8_t looks;
};

using HintExplorer = Explorer<Local, threads, word_count>;

ModelAtomic word(Context& context, std::size_t index) {
  return ModelAtomic(context, index);
}

bool release_round(Context& context, Local&, std::size_t thread) {
  const std::uint32_t slot = slot_of[thread];
  ModelAtomic summary = word(context, top), leaf = word(context, leaf_0 + slot / 64);
  if (scenario.mistake != Mistake::hint_before_release) word(context, first_released + thread).store(1);
  if (scenario.mistake == Mistake::group_before_leaf) {
    summary.fetch_or(Word{1} << slot / 64, std::memory_order_release);
    leaf.fetch_or(Word{1} << slot % 64, std::memory_order_release);
  } else {
    segment::add_hint(summary, leaf, slot, slots);
  }
  if (scenario.mistake == Mistake::hint_before_release) word(context, first_released + thread).store(1);
  return false;
}

void look_at(Context& context, Local& local, std::uint32_t slot) {
  for (std::size_t i = 0; i < 2; ++i) {
    if (slot_of[i] == slot && word(context, first_released + i).load(std::memory_order_acquire) != 0)
      local.found[i] = 1;
  }
}

void look_wrongly(Context& context, Local& local) {
  const Word bits = word(context, leaf_1).exchange(0, std::memory_order_acquire);
  if (word(context, top).exchange(0, std::memory_order_acquire) == 0 && bits == 0) return;
  for (const std::uint32_t slot : slot_of) {
    if (bits >> slot % 64 & 1) look_at(context, local, slot);
  }
}

// A look empties the set: a reader of its own each time, as nothing is left in it then.
bool allocate_round(Context& context, Local& local, std::size_t) {
  if (scenario.mistake == Mistake::leaf_before_group) {
    look_wrongly(context, local);
  } else {
    segment::HintReader reader(slots);
    ModelAtomic summary = word(context, top);
    for (;;) {
      const auto leaf_at = [&context](std::uint32_t leaf) { return word(context, leaf_0 + leaf); };
      const std::uint32_t slot = reader.next(summary, leaf_at);
      if (slot == segment::no_slot) break;
      look_at(context, local, slot);
    }
  }
  return ++local.looks < 3;
}

// What was not found must still be hinted at: both its group and its leaf.
void check_end(const HintExplorer::State& state) {
  const Local& local = state.thread[allocator].local;
  for (std::size_t i = 0; i < 2; ++i) {
    const bool group = state.shared[top] >> slot_of[i] / 64 & 1;
    const bool leaf = state.shared[leaf_1] >> slot_of[i] % 64 & 1;
    if (!local.found[i] && !(group && leaf)) throw Violation{"a release was not found and never will be"};
  }
}

int run() {
  HintExplorer explorer;
  explorer.programs = {release_round, release_round, allocate_round};
  explorer.check_end = check_end;
  return Exploration<Scenario, HintExplorer>(explorer, scenario).explore(scenarios, mistakes);
}

}  // namespace
}  // namespace model
}  // namespace tzc

int main() {
  return tzc::model::run();
}
