// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "engine/options.h"
#include "engine/other_code.h"
#include "solve/port_edits.h"
#include "solve/solution.h"

#include "verify/verify.h"

namespace tzc::rewriter {

/// Solves, edits, verifies and demotes until the rest compiles.
class DemotionLoop {
 public:
  DemotionLoop(const Facts& facts, const Components& components, const EngineOptions& options,
               const OtherCodeLimits& others, Verifier& verifier, ReadFile read)
      : facts_(facts),
        components_(components),
        options_(options),
        others_(others),
        verifier_(verifier),
        read_(std::move(read)),
        trials_left_(least_trials + number_of_units(facts)) {}

  struct Result {
    Solution solution;
    PortEdits plan;
    FileContents contents;
  };
  Expected<Result> run();

 private:
  /// After so many rounds whatever a failing unit sees is demoted at once: each round parses units again.
  static constexpr unsigned careful_rounds = 8;
  /// Trials of one unit each that bisection may make, besides one for each unit; later, too, all is demoted at once. So its cost
  /// is linear in the units, whatever is wrong with them.
  static constexpr std::size_t least_trials = 32;
  static std::size_t number_of_units(const Facts& facts);

  struct Attempt {
    Result result;
    std::vector<Failure> failures;
  };
  Attempt planned(const Demotions& demotions) const;
  /// `only`: the main files to verify; empty: all.
  Expected<void> verify(Attempt& attempt, const std::set<std::string>& only, Judge judge) const;
  Expected<bool> demote_some(const Attempt& failed);
  bool demote_suspects(const Attempt& attempt);
  bool demote_all_of(const Attempt& failed);
  Expected<void> demote_by_bisection(const Attempt& failed);
  Expected<std::optional<ComponentId>> culprit_of(const Failure& failure);
  Expected<bool> is_gone_without(const Failure& failure, const std::vector<ComponentId>& components);
  bool demote_for_others(const Attempt& attempt);
  bool demote_unwritable(const Attempt& attempt);
  static std::set<ComponentId> components_behind(const Edit& edit, const Edits& plan);
  struct Why {
    const char* code;
    std::string reason;
  };
  void demote_edit(const Edit& edit, const Edits& plan, const Why& why);
  void demote(ComponentId component, const Failure& failure);
  const char* demotion_code(ComponentId component, const char* code) const;
  bool is_message(ComponentId component) const;
  std::vector<ComponentId> ported_components(const Attempt& attempt) const;

  const Facts& facts_;
  const Components& components_;
  const EngineOptions& options_;
  const OtherCodeLimits& others_;
  Verifier& verifier_;
  ReadFile read_;
  Demotions demotions_;
  unsigned round_ = 0;
  std::size_t trials_left_;
};

}  // namespace tzc::rewriter
