// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdio>
#include <string>

namespace tzc {
namespace model {

/// A mistake that the exploration of at least one scenario must find.
template <class Mistake>
struct Planted {
  Mistake mistake;
  const char* name;
};

/// Explores every scenario with copies of an explorer that knows the programs; they look at `current` for
/// theirs.
template <class Scenario, class Explorer>
class Exploration {
 public:
  using State = typename Explorer::State;

  Exploration(const Explorer& explorer, Scenario& current, const State& start = State{})
      : explorer_(explorer), current_(current), start_(start) {}
  /// A start that depends on the scenario.
  Exploration& starts_with(State (*start_of)(const Scenario&)) {
    start_of_ = start_of;
    return *this;
  }

  /// Then plants each mistake in the scenarios until one finds it. Returns the number of failures.
  template <std::size_t scenario_count, class Mistake, std::size_t mistake_count>
  int explore(const Scenario (&scenarios)[scenario_count],
              const Planted<Mistake> (&mistakes)[mistake_count]) {
    int failures = 0;
    for (const Scenario& each : scenarios) failures += holds(each, true) ? 0 : 1;
    for (const Planted<Mistake>& planted : mistakes) {
      std::string found;
      for (Scenario broken : scenarios) {
        broken.mistake = planted.mistake;
        if (found.empty() && !holds(broken, false)) found = broken.name;
      }
      std::printf("planted: %s: %s\n", planted.name,
                  found.empty() ? "NOT FOUND" : ("found in " + found).c_str());
      failures += found.empty() ? 1 : 0;
    }
    return failures;
  }

 private:
  bool holds(const Scenario& scenario, bool print) {
    current_ = scenario;
    Explorer explorer = explorer_;
    explorer.most_deaths = scenario.deaths;
    const bool held = explorer.explore(start_of_ ? start_of_(scenario) : start_);
    if (print)
      std::printf("%-32s %9zu states  %s\n", scenario.name, explorer.states(),
                  held ? "holds" : explorer.violation().c_str());
    if (print && !held) std::printf("  %s\n", explorer.trace().c_str());
    std::fflush(stdout);
    return held;
  }

  const Explorer& explorer_;
  Scenario& current_;
  const State start_;
  State (*start_of_)(const Scenario&) = nullptr;
};

}  // namespace model
}  // namespace tzc
