// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "model/edit.h"
#include "model/expected.h"
#include "model/facts.h"
#include "model/folder_set.h"
#include "model/judges.h"
#include "parse/parse.h"
#include "rules/rule.h"
#include "solve/components.h"
#include "verify/attribution.h"
#include "verify/callees.h"
#include "verify/idle_allocations.h"

namespace tzc::rewriter {

enum class Judge { both, clang, compiler };

/// An error of the edited sources, and the components that may have caused it, likeliest first.
struct Failure {
  Diagnostic error;
  std::string unit;
  Judge judge = Judge::both;  ///< who found it
  LineRange origin;           ///< the lines of the original that its line stands for
  std::vector<ComponentId> suspects;
  std::vector<ComponentId> candidates;  ///< those that the error's lines name first, then all of the unit's
  std::size_t named = 0;                ///< how many of the candidates are named there

  /// Whether it is the same error with other edits, which may move it and change its words.
  bool is_same(const Failure& other) const;
};

struct Verification {
  std::vector<Failure> failures;
  FileContents contents;  ///< the edited files
};

/// What a verification compares the edited packages with.
struct VerifiedPackages {
  const std::vector<CompileUnit>& units;
  const Facts& facts;
  const CallsOfUnits& calls;
  const Components& components;
  const RuleSet& rules;
  FolderSet folders;
};

/// What to verify.
struct VerifyRequest {
  const Edits& edits;
  std::set<std::string> only;  ///< main files; empty: every unit that includes an edited file
  Judge judge = Judge::both;   ///< both: the compiler is asked about what Clang accepts
  std::function<void(unsigned, unsigned)> progress;
};

/// Parses every unit that includes an edited file, with the new text in memory, and runs the package's
/// compiler. A unit is verified again only when the text of a file that it includes changed.
class Verifier {
 public:
  Verifier(VerifiedPackages packages, ParseOptions options, unsigned jobs, ReadFile read, Judges judges)
      : packages_(std::move(packages)),
        options_(std::move(options)),
        jobs_(jobs),
        read_(std::move(read)),
        judges_(std::move(judges)) {}

  /// An error when edits contradict each other, or the compiler cannot be run.
  Expected<Verification> run(const VerifyRequest& request);

 private:
  using Judgement = std::vector<std::pair<std::string, Diagnostic>>;  ///< unit and error
  Expected<FileContents> written(const Edits& edits) const;
  std::vector<const CompileUnit*> touched(const FileContents& contents,
                                          const std::set<std::string>& only) const;
  /// A key of the texts of a unit.
  std::string key_of(const std::string& unit, const FileContents& contents) const;
  Judgement ask_clang(const VerifyRequest& request, const FileContents& contents,
                      const Attribution& attribution);
  Expected<Judgement> ask_compiler(const VerifyRequest& request, const FileContents& contents);
  /// Calls that would pick another function than before, as errors.
  std::vector<Diagnostic> changed_calls(const CompileUnit& unit, const std::vector<PackageCall>& now,
                                        const Attribution& attribution) const;
  /// Those that edits wrote, as errors.
  std::vector<Diagnostic> idle_edits(const std::vector<IdleAllocation>& idle,
                                     const Attribution& attribution) const;
  void attribute(Failure& failure, const Attribution& attribution) const;

  VerifiedPackages packages_;
  ParseOptions options_;
  unsigned jobs_;
  ReadFile read_;
  Judges judges_;
  std::map<std::string, std::vector<Diagnostic>> clang_said_, compiler_said_;  ///< by key
};

}  // namespace tzc::rewriter
