// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <vector>

#include "edits/source_text.h"

namespace tzc::rewriter {

/// Which parts of a file the preprocessor never compiles together, as far as the text shows it. Immutable.
///
/// Two parts exclude each other where they are branches of one conditional, where the conditions around them contradict each other
/// (`#ifdef A`, `#ifndef A`), or where both define a class of the same name: a unit that compiles both of them is ill-formed.
class ConditionalCode {
 public:
  /// A text without comments (without_comments).
  explicit ConditionalCode(const std::string& text);

  /// Whether no unit compiles what stands at the offset together with anything in the range, which begins at a directive.
  bool excludes(const TextRange& range, std::size_t offset) const;

 private:
  /// From behind the line of an #if, #elif or #else up to the next of its conditional.
  struct Branch {
    std::size_t begin, end;
    std::size_t parent, conditional;
    std::set<std::string> conditions;  ///< of its own, all of which hold where it is compiled
  };
  struct Class {
    std::string name;
    std::size_t branch;
  };
  class Reader;

  std::size_t branch_at(std::size_t offset) const;
  bool is_within(std::size_t branch, std::size_t outer) const;
  bool excludes(std::size_t one, std::size_t other) const;
  bool contradicts(std::size_t one, std::size_t other) const;
  bool defines_again(std::size_t one, std::size_t other) const;

  std::vector<Branch> branches_;   ///< the first one is the whole file
  std::vector<Class> classes_;     ///< of namespaces
  std::set<std::string> changed_;  ///< macros that the file defines or undefines
  std::set<std::size_t> includes_;
};

}  // namespace tzc::rewriter
