// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "engine/port_plan.h"
#include "model/folder_set.h"
#include "solve/port_edits.h"

namespace tzc::rewriter {

/// Main file -> the folder of the package that compiles it; a unity build's lies in the build folder.
using UnitOwners = std::map<std::string, std::string>;

/// Gives each package its part of what was planned for several.
class PlanSplitter {
 public:
  /// The arguments must outlive the object.
  PlanSplitter(const FolderSet& packages, const UnitOwners& owners, const UnitsOfFile& units_of_file);

  void add(std::vector<Site> sites);
  void add(std::vector<Note> notes);
  /// Joins the packages that the edits make depend on each other.
  void add(const PortEdits& edits, const FileContents& contents);

  PortPlans plans() { return std::move(plans_); }

 private:
  PortPlan& plan_of(const std::string& file);
  std::set<std::string> users_of(const std::string& file) const;
  void add_headers(const std::map<std::string, std::set<std::string>>& headers);
  void join(const std::set<std::string>& packages);

  const UnitOwners& owners_;
  const UnitsOfFile& units_of_file_;
  const FolderSet& packages_;
  PortPlans plans_;
};

}  // namespace tzc::rewriter
