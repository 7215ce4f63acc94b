// SPDX-License-Identifier: BSD-3-Clause
#include "other_code/unseen_files.h"

#include <filesystem>
#include <utility>

#include "edits/files.h"
#include "other_code/text_files.h"

namespace tzc::rewriter {
namespace fs = std::filesystem;
namespace {

/// Also `node.cpp.in`, which configure_file() turns into one.
bool is_code(fs::path file) {
  if (file.extension() == ".in") file = file.stem();
  return is_cpp_source(file.string()) || is_cpp_header(file.string()) || is_cuda_source(file.string());
}

}  // namespace

IncludeGraph::IncludeGraph(const FolderSet& packages) : packages_(packages), headers_(packages) {
  TextFiles files([this](const std::string& file) { add(file); });
  for (const std::string& package : packages) files.walk(package);
}

void IncludeGraph::add_compiled(const std::string& file) {
  code_.insert(file);
  add(file);
}

void IncludeGraph::add(const std::string& file) {
  if (is_code(file)) code_.insert(file);
  if (included_.count(file) != 0) return;
  if (std::set<std::string> included = headers_.included_by(file); !included.empty())
    included_.emplace(file, std::move(included));
}

const IncludeGraph& IncludeGraphs::of(const std::set<std::string>& packages) {
  const auto known = graphs_.find(packages);
  if (known != graphs_.end()) return known->second;
  const FolderSet folders(std::vector<std::string>(packages.begin(), packages.end()));
  return graphs_.emplace(packages, IncludeGraph(folders)).first->second;
}

const std::set<std::string>& IncludeGraph::included_by(const std::string& file) const {
  static const std::set<std::string> nothing;
  const auto found = included_.find(file);
  return found == included_.end() ? nothing : found->second;
}

std::set<std::string> IncludeGraph::reached_from(const std::string& file) const {
  std::set<std::string> reached;
  std::vector<std::string> open{file};
  while (!open.empty()) {
    const auto found = included_.find(open.back());
    open.pop_back();
    if (found == included_.end()) continue;
    for (const std::string& header : found->second)
      if (reached.insert(header).second) open.push_back(header);
  }
  return reached;
}

std::vector<UnseenFile> unseen_files(const IncludeGraph& graph, const FolderSet& packages,
                                     const std::map<std::string, std::set<std::string>>& units_of_file) {
  const auto place_of = [&](const std::string& file) {
    if (packages.hold(file)) return UnseenFile::Place::package;
    return graph.packages().hold(file) ? UnseenFile::Place::other_package : UnseenFile::Place::elsewhere;
  };
  std::vector<UnseenFile> found;
  for (const std::string& file : graph.code()) {
    if (units_of_file.count(file) != 0) continue;
    UnseenFile unseen{file, {}, place_of(file)};
    for (const std::string& header : graph.reached_from(file))
      if (packages.hold(header)) unseen.headers.insert(header);
    if (!unseen.headers.empty()) found.push_back(std::move(unseen));
  }
  return found;
}

}  // namespace tzc::rewriter
