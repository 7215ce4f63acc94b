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
        read_(std::move(read)) {}

  struct Result {
    Solution solution;
    PortEdits plan;
    FileContents contents;
  };
  Expected<Result> run();

 private:
  /// After so many rounds whatever a failing unit sees is demoted at once: each round parses units again.
  static constexpr unsigned careful_rounds = 8;

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
  Expected<std::optional<ComponentId>> culprit_of(const Failure& failure) const;
  Expected<bool> is_gone_without(const Failure& failure, const std::vector<ComponentId>& components) const;
  bool demote_for_others(const Attempt& attempt);
  void demote(ComponentId component, const Failure& failure);
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
};

}  // namespace tzc::rewriter
