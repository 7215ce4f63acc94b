// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "edits/edit.h"
#include "facts/facts.h"
#include "facts/parse.h"
#include "solve/components.h"
#include "solve/plan.h"

namespace tzc::rewriter {

/// An error of the edited sources, and the components that may have caused it, likeliest first.
struct Failure {
  Diagnostic error;
  std::string unit;
  std::vector<int> suspects;
};

struct Verification {
  std::vector<Failure> failures;
  FileContents contents;  ///< the edited files
};

/// Parses every unit that includes an edited file, with the edits in memory.
class Verifier {
 public:
  Verifier(const std::vector<CompileUnit>& units, const Facts& facts, const Components& components,
           ParseOptions options, std::string package_dir, unsigned jobs, ReadFile read)
      : units_(units),
        facts_(facts),
        components_(components),
        options_(std::move(options)),
        package_dir_(std::move(package_dir)),
        jobs_(jobs),
        read_(std::move(read)) {}

  /// An error when edits contradict each other.
  Expected<Verification> run(const Edits& edits,
                             const std::function<void(unsigned, unsigned)>& progress) const;

 private:
  Expected<FileContents> edited(const Edits& edits) const;
  std::set<std::string> touched(const FileContents& contents) const;
  std::vector<int> suspects_of(const Diagnostic& error, const std::map<std::string, Edits>& edits) const;
  /// Calls that would pick another function than before, as errors.
  std::vector<Diagnostic> changed_calls(const std::string& unit, const std::vector<PackageCall>& now,
                                        const std::map<std::string, Edits>& edits) const;
  unsigned original(const std::string& file, unsigned line, const std::map<std::string, Edits>& edits) const;
  bool owns_line(int component, const std::string& file, unsigned line) const;

  const std::vector<CompileUnit>& units_;
  const Facts& facts_;
  const Components& components_;
  ParseOptions options_;
  std::string package_dir_;
  unsigned jobs_;
  ReadFile read_;
};

}  // namespace tzc::rewriter
