// SPDX-License-Identifier: BSD-3-Clause
// usage: hint_memory_model
// The hints of releases (segment/release_hints.h) in every execution that the C++ memory model allows: two threads
// release a slot each and hint at it, the allocator looks twice. What it did not find released is still hinted at.
// Then weakens each memory order of that code and demands that it is found.
#include "segment/release_hints.h"
#include "weak/weakenings.h"

namespace tzc {
namespace model {
namespace {

using weak::Atomic;
using weak::Context;
using weak::Explorer;
using weak::Outcome;
using weak::Word;

constexpr std::uint32_t slots = 64 * 2;  // two leaves, each a group of its own
constexpr std::size_t allocator = 2;

enum Location : std::size_t { top, leaf_0, leaf_1, first_released, second_released, location_count };

const weak::Names names{{"first", "second", "allocator"}, {"top", "leaf 0", "leaf 1"}};

/// Which slot each releases.
struct Releases {
  std::uint32_t slot[2];
};

void release(Context& context, std::size_t which, std::uint32_t slot) {
  Atomic(context, first_released + which).store(1, std::memory_order_relaxed);
  Atomic summary(context, top), leaf(context, leaf_0 + slot / 64);
  segment::add_hint(summary, leaf, slot, slots);
}

// The notes are what it found released.
void look(Context& context, const Releases& releases) {
  segment::HintReader reader(slots);
  Atomic summary(context, top);
  const auto leaf_at = [&context](std::uint32_t leaf) { return Atomic(context, leaf_0 + leaf); };
  for (;;) {
    const std::uint32_t slot = reader.next(summary, leaf_at);
    if (slot == segment::no_slot) return;
    for (std::size_t i = 0; i < 2; ++i) {
      const bool hinted = releases.slot[i] == slot;
      if (hinted && Atomic(context, first_released + i).load(std::memory_order_acquire) != 0) context.note(i);
    }
  }
}

void check_end(const Outcome& outcome, const Releases& releases) {
  for (std::size_t i = 0; i < 2; ++i) {
    bool found = false;
    for (const Word note : outcome.notes[allocator]) found = found || note == i;
    const std::uint32_t slot = releases.slot[i];
    const bool hinted =
        (outcome.last[top] >> slot / 64 & 1) != 0 && (outcome.last[leaf_0 + slot / 64] >> slot % 64 & 1) != 0;
    if (!found && !hinted) throw weak::Violation{"a release was not found and never will be"};
  }
}

weak::Scenario scenario(const char* name, const Releases& releases) {
  return {name, [releases] {
            Explorer explorer;
            explorer.initial.assign(location_count, 0);
            for (std::size_t i = 0; i < 2; ++i) {
              explorer.threads.push_back(
                  [i, releases](Context& context) { release(context, i, releases.slot[i]); });
            }
            explorer.threads.push_back([releases](Context& context) {
              look(context, releases);
              look(context, releases);
            });
            explorer.on_end = [releases](const Outcome& outcome) { check_end(outcome, releases); };
            return explorer;
          }};
}

int run() {
  const std::vector<weak::Scenario> scenarios{
      scenario("in one leaf", {{65, 70}}),
      scenario("in the first leaf", {{3, 5}}),
      scenario("in two leaves", {{3, 70}}),
  };
  return weak::explore_with_weakenings(scenarios, names, {});
}

}  // namespace
}  // namespace model
}  // namespace tzc

int main() {
  return tzc::model::run();
}
