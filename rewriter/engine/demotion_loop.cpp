// SPDX-License-Identifier: BSD-3-Clause
#include "engine/demotion_loop.h"

#include <algorithm>

#include "edits/apply.h"
#include "edits/includes.h"
#include "edits/line_endings.h"
#include "model/codes.h"
#include "solve/solve.h"
#include "verify/swallowed_edit.h"

namespace tzc::rewriter {

std::size_t DemotionLoop::number_of_units(const Facts& facts) {
  std::set<std::string> units;
  for (const auto& item : facts.units_of_file) units.insert(item.second.begin(), item.second.end());
  return units.size();
}

/// A subscription has one code for all that.
const char* DemotionLoop::demotion_code(ComponentId component, const char* code) const {
  const ComponentKind kind = components_[component].kind;
  const bool receives = kind == ComponentKind::subscription || kind == ComponentKind::filter;
  return receives ? codes::TZC2005 : code;
}

/// The error's own place is one of the ported text, which nobody will see.
void DemotionLoop::demote(ComponentId component, const Failure& failure) {
  Location where = failure.error.where;
  if (failure.origin.first != 0 && !failure.origin.has(where.line))
    where = {where.file, failure.origin.first, 1};
  const std::string words = failure.error.compiles ? "ported, " : "ported, it would not compile: ";
  demotions_.emplace(component,
                     Obstacle{demotion_code(component, codes::TZC1009), words + failure.error.text, where});
}

DemotionLoop::Attempt DemotionLoop::planned(const Demotions& demotions) const {
  Attempt attempt;
  attempt.result.solution = solve(facts_, components_, options_, demotions);
  PortEdits& plan = attempt.result.plan = edits_of(facts_, components_, attempt.result.solution, options_);
  const Edits includes = include_edits(plan.headers, plan.edits, read_);
  plan.edits.insert(plan.edits.end(), includes.begin(), includes.end());
  keep_line_endings(plan.edits, read_);
  return attempt;
}

Expected<void> DemotionLoop::verify(Attempt& attempt, const std::set<std::string>& only, Judge judge) const {
  const auto progress = [&](unsigned done, unsigned total) {
    if (options_.progress)
      options_.progress->step(round_ == 0 ? "verifying" : "verifying again", done, total,
                              *options_.packages.begin());
  };
  Expected<Verification> verification = verifier_.run({attempt.result.plan.edits, only, judge, progress});
  if (!verification) return verification.error();
  attempt.result.contents = std::move(verification->contents);
  attempt.failures = std::move(verification->failures);
  return {};
}

bool DemotionLoop::is_message(ComponentId component) const {
  return components_[component].kind == ComponentKind::message;
}

/// Messages are demoted first: a publisher can be ported without its message.
bool DemotionLoop::demote_suspects(const Attempt& attempt) {
  const std::size_t before = demotions_.size();
  for (const Failure& failure : attempt.failures) {
    if (failure.suspects.empty()) continue;
    const auto message = std::find_if(failure.suspects.begin(), failure.suspects.end(),
                                      [this](ComponentId id) { return is_message(id); });
    demote(message == failure.suspects.end() ? failure.suspects.front() : *message, failure);
  }
  return demotions_.size() > before;
}

std::vector<ComponentId> DemotionLoop::ported_components(const Attempt& attempt) const {
  std::set<ComponentId> ids;
  for (const Edit& edit : attempt.result.plan.edits)
    if (edit.component) ids.insert(*edit.component);
  return {ids.begin(), ids.end()};
}

/// Whether the error is gone when these are not ported; the unit may have others. Only that unit is looked at,
/// by the judge that found the error.
Expected<bool> DemotionLoop::is_gone_without(const Failure& failure,
                                             const std::vector<ComponentId>& components) {
  if (trials_left_ > 0) --trials_left_;
  Demotions trial = demotions_;
  for (const ComponentId component : components)
    trial.emplace(component, Obstacle{codes::TZC1009, "", failure.error.where});
  Attempt without = planned(trial);
  if (Expected<void> done = verify(without, {failure.unit}, failure.judge); !done) return done.error();
  return std::none_of(without.failures.begin(), without.failures.end(),
                      [&](const Failure& left) { return left.is_same(failure); });
}

/// The component without which the error is gone: first among those that the error's lines name, then among all
/// that the unit sees, in halves. Costs a parse of one unit for each step.
Expected<std::optional<ComponentId>> DemotionLoop::culprit_of(const Failure& failure) {
  std::vector<ComponentId> suspects = failure.candidates;
  const auto message = [this](ComponentId id) { return is_message(id); };
  const auto named_end = suspects.begin() + static_cast<long>(failure.named);
  std::stable_partition(suspects.begin(), named_end, message);  // a message goes first
  std::stable_partition(named_end, suspects.end(), message);
  if (failure.named > 0 && failure.named < suspects.size()) {
    const Expected<bool> named = is_gone_without(failure, {suspects.begin(), named_end});
    if (!named) return named.error();
    *named ? suspects.erase(named_end, suspects.end()) : suspects.erase(suspects.begin(), named_end);
  }
  while (suspects.size() > 1) {
    const auto half = suspects.begin() + static_cast<long>(suspects.size() / 2);
    const Expected<bool> first = is_gone_without(failure, {suspects.begin(), half});
    if (!first) return first.error();
    *first ? suspects.erase(half, suspects.end()) : suspects.erase(suspects.begin(), half);
  }
  return suspects.empty() ? std::nullopt : std::optional<ComponentId>(suspects.front());
}

/// No edit owns the errors: tries each failing unit with fewer components. The culprit of one unit may be
/// that of others, so it first tries a unit unchanged again.
Expected<void> DemotionLoop::demote_by_bisection(const Attempt& failed) {
  std::set<std::string> seen;
  for (const Failure& failure : failed.failures) {
    if (trials_left_ == 0) break;
    if (!seen.insert(failure.unit).second) continue;
    if (seen.size() > 1) {
      const Expected<bool> healed = is_gone_without(failure, {});
      if (!healed) return healed.error();
      if (*healed) continue;
    }
    const Expected<std::optional<ComponentId>> culprit = culprit_of(failure);
    if (!culprit) return culprit.error();
    const std::vector<ComponentId> ported = ported_components(failed);
    if (*culprit)
      demote(**culprit, failure);
    else if (!ported.empty())
      demote(ported.front(), failure);
  }
  return {};
}

/// What no parse would show.
bool DemotionLoop::demote_for_others(const Attempt& attempt) {
  const std::size_t before = demotions_.size();
  for (const auto& [component, why] : others_.broken_by(attempt.result.plan))
    demotions_.emplace(component, why);
  return demotions_.size() > before;
}

/// The components of an edit; of one that belongs to the file as a whole: all that change the file.
std::set<ComponentId> DemotionLoop::components_behind(const Edit& edit, const Edits& plan) {
  if (edit.component) return {*edit.component};
  std::set<ComponentId> components;
  for (const Edit& other : plan)
    if (other.component && other.file == edit.file) components.insert(*other.component);
  return components;
}

void DemotionLoop::demote_edit(const Edit& edit, const Edits& plan, const Why& why) {
  const std::string text = read_(edit.file).value_or("");
  const auto end = text.begin() + static_cast<long>(std::min(edit.offset, text.size()));
  const Location where{edit.file, static_cast<unsigned>(std::count(text.begin(), end, '\n')) + 1, 1};
  for (const ComponentId component : components_behind(edit, plan))
    demotions_.emplace(component, Obstacle{demotion_code(component, why.code), why.reason, where});
}

/// Text that two components would change in different ways, as that of a template does which is two things to its instances;
/// and text that would not be read as the code that it is.
bool DemotionLoop::demote_unwritable(const Attempt& attempt) {
  const std::size_t before = demotions_.size();
  const Edits& plan = attempt.result.plan.edits;
  for (const auto& [first, second] : overlaps(plan))
    for (const Edit& edit : {first, second})
      if (edit.component)
        demote_edit(edit, plan,
                    {codes::TZC1007, "its port would change text that another one's changes otherwise"});
  if (demotions_.size() > before) return true;
  for (const auto& [file, of_file] : by_file(plan)) {
    const std::string text = read_(file).value_or("");
    const Expected<std::string> edited = apply_edits(text, of_file);
    if (const std::optional<Edit> edit = edited ? swallowed_edit(text, of_file, *edited) : std::nullopt)
      demote_edit(*edit, plan,
                  {codes::TZC1009,
                   "what its port writes here would be read as part of a comment, a string or a directive"});
  }
  return demotions_.size() > before;
}

/// All that a failing unit sees, so that a package with many errors ends, too.
bool DemotionLoop::demote_all_of(const Attempt& failed) {
  const std::size_t before = demotions_.size();
  for (const Failure& failure : failed.failures) {
    for (const ComponentId component : failure.suspects) demote(component, failure);
    for (const ComponentId component : failure.candidates) demote(component, failure);
  }
  return demotions_.size() > before;
}

/// False: nothing more can be taken away.
Expected<bool> DemotionLoop::demote_some(const Attempt& failed) {
  if ((round_ >= careful_rounds || trials_left_ == 0) && demote_all_of(failed)) return true;
  if (demote_suspects(failed)) return true;
  const std::size_t before = demotions_.size();
  if (Expected<void> done = demote_by_bisection(failed); !done) return done.error();
  if (demotions_.size() > before) return true;
  for (const ComponentId component : ported_components(failed)) demote(component, failed.failures.front());
  return demotions_.size() > before;
}

Expected<DemotionLoop::Result> DemotionLoop::run() {
  for (;; ++round_) {
    Attempt attempt = planned(demotions_);
    const bool judged = options_.without_rules.count("verification") == 0;
    if (demote_unwritable(attempt)) continue;
    if (judged && demote_for_others(attempt)) continue;
    if (Expected<void> done = verify(attempt, {}, Judge::both); !done) return done.error();
    if (attempt.failures.empty() || !judged) return std::move(attempt.result);
    const Expected<bool> demoted = demote_some(attempt);
    if (!demoted) return demoted.error();
    if (!*demoted)
      return Error{
          "the unchanged package does not compile: " + attempt.failures[0].error.text,
          attempt.failures[0].unit,
          "Clang and the package's compiler must accept each unit as it is; please report it when they do."};
  }
}

}  // namespace tzc::rewriter
