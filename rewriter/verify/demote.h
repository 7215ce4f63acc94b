// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "solve/solution.h"
#include "verify/verify.h"

namespace tzc::rewriter {

/// Solves, edits, verifies and demotes until what is left compiles.
class Porter {
 public:
  Porter(const Facts& facts, const Components& components, const EngineOptions& options,
         const Verifier& verifier, ReadFile read)
      : facts_(facts),
        components_(components),
        options_(options),
        verifier_(verifier),
        read_(std::move(read)) {}

  struct Result {
    Solution solution;
    EditPlan plan;
    FileContents contents;
  };
  Expected<Result> run();

 private:
  struct Attempt {
    Result result;
    std::vector<Failure> failures;
  };
  Expected<Attempt> attempt(const Demotions& demotions, unsigned round) const;
  bool demote_suspects(const Attempt& attempt);
  void demote_by_bisection(const Attempt& attempt);
  void demote(int component, const Failure& failure);
  std::string name_of(int component) const;
  std::vector<int> ported_components(const Attempt& attempt) const;

  const Facts& facts_;
  const Components& components_;
  const EngineOptions& options_;
  const Verifier& verifier_;
  ReadFile read_;
  Demotions demotions_;
};

}  // namespace tzc::rewriter
