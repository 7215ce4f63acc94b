// SPDX-License-Identifier: BSD-3-Clause
#include "verify/demote.h"

#include <algorithm>
#include <iterator>

#include "report/codes.h"

namespace tzc::rewriter {

std::string Porter::name_of(int component) const {
  const auto count = static_cast<int>(components_.all().size());
  if (component < count) return components_.all()[static_cast<std::size_t>(component)].name;
  auto position = facts_.subscribes.begin();
  std::advance(position, component - count);
  return "subscribe " + position->first;
}

void Porter::demote(int component, const Failure& failure) {
  const bool subscribe = component >= static_cast<int>(components_.all().size()) ||
                         components_.all()[static_cast<std::size_t>(component)].carrier == Carrier::filter;
  demotions_.emplace(name_of(component),
                     Obstacle{subscribe ? codes::TZC2005 : codes::TZC1009,
                              "ported, it would not compile: " + failure.error.text, failure.error.where});
}

Expected<Porter::Attempt> Porter::attempt(const Demotions& demotions, unsigned round) const {
  Attempt attempt;
  attempt.result.solution = solve(facts_, components_, options_, demotions);
  attempt.result.plan = edits_of(facts_, components_, attempt.result.solution, options_, read_);
  const auto progress = [&](unsigned done, unsigned total) {
    if (options_.progress)
      options_.progress->step(round == 0 ? "verifying" : "verifying again", done, total,
                              options_.package_dir);
  };
  Expected<Verification> verification = verifier_.run(attempt.result.plan.edits, progress);
  if (!verification) return verification.error();
  attempt.result.contents = std::move(verification->contents);
  attempt.failures = std::move(verification->failures);
  return attempt;
}

/// A message goes first: its publisher may be ported without it.
bool Porter::demote_suspects(const Attempt& attempt) {
  const std::size_t before = demotions_.size();
  for (const Failure& failure : attempt.failures) {
    if (failure.suspects.empty()) continue;
    const auto message = std::find_if(failure.suspects.begin(), failure.suspects.end(), [&](int id) {
      return id < static_cast<int>(components_.all().size()) &&
             components_.all()[static_cast<std::size_t>(id)].carrier == Carrier::message;
    });
    demote(message == failure.suspects.end() ? failure.suspects.front() : *message, failure);
  }
  return demotions_.size() > before;
}

std::vector<int> Porter::ported_components(const Attempt& attempt) const {
  std::set<int> ids;
  for (const Edit& edit : attempt.result.plan.edits)
    if (edit.component >= 0) ids.insert(edit.component);
  return {ids.begin(), ids.end()};
}

/// No edit owns the error: halves are taken away until the rest compiles.
void Porter::demote_by_bisection(const Attempt& failed) {
  std::vector<int> suspects = ported_components(failed);
  while (suspects.size() > 1) {
    const std::size_t half = suspects.size() / 2;
    Demotions trial = demotions_;
    for (std::size_t i = 0; i < half; ++i)
      trial.emplace(name_of(suspects[i]), Obstacle{codes::TZC1009, "", failed.failures[0].error.where});
    const Expected<Attempt> without = attempt(trial, 1);
    const bool first_half = without && without->failures.empty();
    suspects = first_half ? std::vector<int>(suspects.begin(), suspects.begin() + static_cast<long>(half))
                          : std::vector<int>(suspects.begin() + static_cast<long>(half), suspects.end());
  }
  if (!suspects.empty()) demote(suspects.front(), failed.failures.front());
}

Expected<Porter::Result> Porter::run() {
  for (unsigned round = 0;; ++round) {
    Expected<Attempt> attempted = attempt(demotions_, round);
    if (!attempted) return attempted.error();
    if (attempted->failures.empty() || options_.without_rules.count("verification"))
      return std::move(attempted->result);
    if (ported_components(*attempted).empty())
      return Error{"the unchanged package does not compile: " + attempted->failures[0].error.text,
                   attempted->failures[0].unit, "Build the package once, then run again."};
    if (!demote_suspects(*attempted)) demote_by_bisection(*attempted);
  }
}

}  // namespace tzc::rewriter
