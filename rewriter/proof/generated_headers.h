// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "buildfiles/compile_database.h"
#include "model/edit.h"
#include "proof/cmake_targets.h"
#include "proof/paths.h"
#include "proof/unit_needs.h"

namespace tzc::rewriter {

/// What keeps the configured build from making TZC's headers before what includes them is compiled.
class GeneratedHeaders {
 public:
  /// `headers`: those that this build has to make, as they are included. `to_user`: the contents' names are the user's. All must
  /// outlive the object.
  GeneratedHeaders(const std::vector<CmakeTarget>& targets, const FileContents& contents,
                   const std::set<std::string>& headers, const PathMap& to_user)
      : targets_(targets), contents_(contents), headers_(headers), to_user_(to_user) {}

  /// None: each header that the unit includes is there when it is compiled, as far as CMake's reply tells.
  std::optional<Lack> lack(const CompileCommand& command, const std::string& unit) const;

 private:
  /// What makes a header, the one that is found first, and whether it does so before the command runs.
  struct Order {
    std::string maker;
    bool is_before = false;
  };
  std::optional<Order> order_of(const CompileCommand& command, const std::string& header) const;
  std::optional<Lack> lack_of_header(const CompileCommand& command, const std::string& header) const;
  std::set<std::string> made_before(const std::string& target) const;
  std::vector<const CmakeTarget*> makers_of(const std::string& path) const;

  const std::vector<CmakeTarget>& targets_;
  const FileContents& contents_;
  const std::set<std::string>& headers_;
  const PathMap& to_user_;
};

}  // namespace tzc::rewriter
