// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <vector>

namespace tzc::msggen {

/// A place in a text file, counted from 1; column counts characters, line 0 means the file as a whole.
struct Position {
  std::size_t line = 0;
  std::size_t column = 0;
};

/// A fault of the input, with what a person needs to correct it.
struct Diagnostic {
  std::string file;
  Position at;
  std::size_t width = 1;    ///< how many characters the fault covers
  std::string source_line;  ///< the line itself, empty when the fault is not in a line
  std::string message;
  std::string hint;  ///< what to do about it, may be empty
};

enum class Severity { error, warning };

/// The compiler-like form: `file:line:column: error: ...`, the line, a caret under the fault, the hint.
std::string render(const Diagnostic& diagnostic, Severity severity = Severity::error);

/// The faults of a run, in the order of their files and lines. The same fault of the same place counts once.
/// Of a file only the first hundred are kept: who gives us megabytes of something else needs no more to see it.
class Diagnostics {
 public:
  static constexpr std::size_t most_of_a_file = 100;

  void report(Diagnostic diagnostic);
  bool empty() const { return all_.empty(); }
  std::size_t size() const { return all_.size(); }
  /// In the order in which they were reported.
  const Diagnostic& operator[](std::size_t i) const { return all_[i]; }
  /// How often report() was called: tells whether something has faults, also where they were not kept.
  std::size_t reported() const { return reported_; }
  /// Whether no more faults of this file will be kept.
  bool has_enough_of(const std::string& file) const;
  /// With a line at the end of each file that has more.
  std::vector<Diagnostic> sorted() const;

 private:
  using Key = std::tuple<std::string, std::size_t, std::size_t, std::string>;

  std::vector<Diagnostic> all_;
  std::set<Key> known_;
  std::map<std::string, std::size_t> found_in_file_;
  std::size_t reported_ = 0;
};

}  // namespace tzc::msggen
