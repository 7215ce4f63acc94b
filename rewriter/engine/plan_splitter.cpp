// SPDX-License-Identifier: BSD-3-Clause
#include "engine/plan_splitter.h"

#include <utility>

namespace tzc::rewriter {

PlanSplitter::PlanSplitter(const FolderSet& packages, const UnitOwners& owners,
                           const UnitsOfFile& units_of_file)
    : owners_(owners), units_of_file_(units_of_file), packages_(packages) {
  for (const std::string& package : packages) {
    Report& report = plans_[package].report;
    report.package_dir = package;
    report.package = package.substr(package.find_last_of('/') + 1);
  }
  for (const auto& [file, units] : units_of_file) plan_of(file).units_of_file.emplace(file, units);
}

PortPlan& PlanSplitter::plan_of(const std::string& file) {
  const std::string* package = packages_.of(file);
  return plans_.at(package != nullptr ? *package : owners_.at(file));
}

/// The packages of which a unit includes the file.
std::set<std::string> PlanSplitter::users_of(const std::string& file) const {
  std::set<std::string> packages;
  const auto units = units_of_file_.find(file);
  if (units == units_of_file_.end()) return packages;
  for (const std::string& unit : units->second) packages.insert(owners_.at(unit));
  return packages;
}

void PlanSplitter::add(std::vector<Site> sites) {
  for (Site& site : sites) plan_of(site.where.file).report.sites.push_back(std::move(site));
}

void PlanSplitter::add(std::vector<Note> notes) {
  for (Note& note : notes) plan_of(note.where->file).report.notes.push_back(std::move(note));
}

void PlanSplitter::add(const PortEdits& edits, const FileContents& contents) {
  std::map<ComponentId, std::set<std::string>> packages_of;
  for (const Edit& edit : edits.edits) {
    plan_of(edit.file).edits.push_back(edit);
    if (edit.component) packages_of[*edit.component].insert(*packages_.of(edit.file));
  }
  for (const auto& item : packages_of) join(item.second);
  for (const auto& [file, content] : contents) {
    plan_of(file).contents.emplace(file, content);
    std::set<std::string> users = users_of(file);
    users.insert(*packages_.of(file));
    join(users);
    const auto units = units_of_file_.find(file);
    if (units == units_of_file_.end()) continue;
    for (const std::string& unit : units->second)
      plans_.at(owners_.at(unit)).ported_targets_files.insert(unit);
  }
  add_headers(edits.headers);
}

void PlanSplitter::add_headers(const std::map<std::string, std::set<std::string>>& headers) {
  for (const auto& [file, names] : headers)
    for (const std::string& user : users_of(file))
      plans_.at(user).needed_headers.insert(names.begin(), names.end());
  for (auto& item : plans_)
    for (const std::string& header : item.second.needed_headers)  // "tzc/sensor_msgs/Image.h"
      if (header.find('/', 4) != std::string::npos)
        item.second.tzc_types.insert(header.substr(4, header.size() - 6));
}

/// With all to which one of them is joined already.
void PlanSplitter::join(const std::set<std::string>& packages) {
  if (packages.size() < 2) return;
  std::set<std::string> all = packages;
  for (const std::string& package : packages) {
    const std::set<std::string>& known = plans_.at(package).joined;
    all.insert(known.begin(), known.end());
  }
  for (const std::string& package : all) {
    plans_.at(package).joined = all;
    plans_.at(package).joined.erase(package);
  }
}

}  // namespace tzc::rewriter
