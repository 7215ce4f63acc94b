// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "model/edit.h"
#include "model/facts.h"
#include "parse/parse.h"
#include "solve/components.h"

namespace tzc::rewriter {

/// The skipped branches that no unit compiles, each once.
std::vector<Place> compiled_by_none(const std::vector<Place>& skipped,
                                    const std::set<BranchDirective>& compiled);

/// Preprocessor branches that no unit compiles in this configuration. No compiler sees them, so entities that
/// they name keep their types. Dead code (`#if 0`) and the branches without TZC of --dual do not count.
class UnseenBranches {
 public:
  UnseenBranches(const std::vector<Place>& unseen, const Facts& facts, const Components& components,
                 const ReadFile& read);

  /// The components with an edit whose variables or functions such a branch names, and where.
  std::map<ComponentId, Obstacle> users_of(const Edits& edits) const;

 private:
  struct Branch {
    Place where;
    std::set<std::string> words;  ///< identifiers
  };
  std::optional<Obstacle> user_of(const Entity& entity) const;
  /// The variable or function of the entity that the branch names; empty: none.
  std::string named_in(const Branch& branch, const Entity& entity) const;
  bool compiled_together(const std::string& file, const std::string& other) const;

  const Facts& facts_;
  const Components& components_;
  std::map<std::string, std::string> texts_;  ///< of files with an entity or a branch
  std::vector<Branch> branches_;
};

}  // namespace tzc::rewriter
