// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "edits/conditional_code.h"
#include "model/edit.h"
#include "model/facts.h"
#include "model/unseen_file.h"
#include "parse/parse.h"
#include "solve/components.h"

namespace tzc::rewriter {

/// The skipped branches that no unit compiles, each once.
std::vector<Place> compiled_by_none(const std::vector<Place>& skipped,
                                    const std::set<BranchDirective>& compiled);

/// The arguments of macros that no unit compiles, each once.
std::vector<Place> dropped_by_all(const std::vector<Place>& dropped, const std::set<ArgumentPlace>& kept);

/// Code that no unit compiles in this configuration.
struct UnseenCode {
  std::vector<Place> branches;  ///< of the preprocessor
  std::vector<UnseenFile> files;
  std::vector<Place> arguments = {};  ///< of macros
};

/// No compiler sees such code here, so entities that it names keep their types. Dead code (`#if 0`) and the branches
/// without TZC of --dual do not count, nor do branches that are never compiled together with anything that the port of a component
/// changes: where they are compiled, nothing of it has changed. Nor does a branch that only calls what a ros::Publisher and a
/// tzc::Publisher both have: it compiles with either, and publishes stock messages.
class UnseenUses {
 public:
  UnseenUses(const UnseenCode& unseen, const Facts& facts, const Components& components,
             const ReadFile& read);

  /// The components with an edit whose variables or functions such code names, and where.
  std::map<ComponentId, Obstacle> users_of(const Edits& edits) const;

 private:
  enum class Kind { branch, argument, file };
  struct Part {
    Kind kind;
    Place where;
    std::string code;                  ///< without comments
    std::set<std::string> words;       ///< its identifiers
    const UnseenFile* file = nullptr;  ///< null: a part of a file that is compiled
  };
  void add(Kind kind, const Place& where, std::string code, const UnseenFile* file = nullptr);
  void add_branch(const Place& place, const ReadFile& read);
  void add_argument(const Place& place, const ReadFile& read);
  void add_file(const UnseenFile& file, const ReadFile& read);
  bool lies_apart(const Part& part, const Edits& edits) const;
  std::optional<Obstacle> user_of(const Component& component, const Edits& edits) const;
  std::optional<Obstacle> use_of(const Entity& entity, const Part& part) const;
  /// The variable or function of the entity that the part names; empty: none.
  std::string named_in(const Part& part, const Entity& entity) const;
  static bool fits_either_class(const Part& part, const Entity& entity);
  bool may_name(const Part& part, const Entity& entity) const;
  bool compiled_together(const std::string& file, const std::string& other) const;

  const Facts& facts_;
  const Components& components_;
  std::map<std::string, std::string> texts_;            ///< of files with an entity or such a branch
  std::map<std::string, ConditionalCode> conditional_;  ///< files with such a branch
  std::vector<Part> parts_;
};

}  // namespace tzc::rewriter
