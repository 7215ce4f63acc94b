// SPDX-License-Identifier: BSD-3-Clause
#include "other_code/header_users.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <sstream>

#include "buildfiles/find_packages.h"
#include "buildfiles/package_xml.h"
#include "edits/files.h"
#include "model/codes.h"
#include "other_code/package_headers.h"
#include "other_code/text_files.h"

namespace tzc::rewriter {
namespace fs = std::filesystem;
namespace {

std::string text_of(const fs::path& file) {
  Expected<std::string> text = read_file(file.string());
  return text ? std::move(*text) : "";
}

/// Source spaces of a catkin workspace that was built into this prefix.
std::vector<std::string> source_spaces(const fs::path& prefix) {
  std::vector<std::string> folders;
  std::istringstream list(text_of(prefix / ".catkin"));
  for (std::string folder; std::getline(list, folder, ';');)
    if (!folder.empty()) folders.push_back(folder);
  return folders;
}

/// "a, b, c"
std::string listed(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

/// Whether the text of a package.xml names the package as a dependency of any kind.
bool depends_on(const std::string& manifest, const std::string& package) {
  for (std::size_t at = manifest.find(package); at != std::string::npos;
       at = manifest.find(package, at + 1)) {
    const std::size_t before = manifest.find_last_not_of(" \t\r\n", at - 1);
    const std::size_t after = manifest.find_first_not_of(" \t\r\n", at + package.size());
    if (before != std::string::npos && after != std::string::npos && manifest[before] == '>' &&
        manifest.compare(after, 2, "</") == 0 &&
        manifest.compare(manifest.find('>', after) - 6, 6, "depend") == 0)
      return true;
  }
  return false;
}

bool depends_on_any(const fs::path& file, const std::set<std::string>& packages) {
  const std::string manifest = text_of(file);
  return std::any_of(packages.begin(), packages.end(),
                     [&](const std::string& package) { return depends_on(manifest, package); });
}

/// The packages at these places: folder, canonical, and name.
std::map<std::string, std::string> packages_at(const std::vector<std::string>& places) {
  std::map<std::string, std::string> found;
  for (const std::string& place : places)
    if (const Expected<std::vector<std::string>> folders = find_packages_at(place))
      for (const std::string& folder : *folders)
        if (const Expected<PackageXml> manifest = read_package_xml(folder)) found[folder] = manifest->name;
  return found;
}

/// Of which the command line names sources.
class NamedPackages {
 public:
  explicit NamedPackages(const std::vector<std::string>& arguments) : folders_(packages_at(arguments)) {
    for (const auto& item : folders_) names_.insert(item.second);
  }
  bool has_name(const std::string& name) const { return names_.count(name) != 0; }
  /// The packages below a folder that it hides; and TZC itself, which takes headers of other packages as they are and ported.
  std::vector<std::string> no_users_in(const std::string& folder) const {
    std::vector<std::string> others;
    for (const auto& [place, name] : packages_at({folder}))
      if (name == "tzc" || (has_name(name) && folders_.count(place) == 0)) others.push_back(place);
    return others;
  }

 private:
  std::map<std::string, std::string> folders_;
  std::set<std::string> names_;
};

}  // namespace

std::vector<Inclusion> inclusions_between(const std::vector<std::string>& packages) {
  const FolderSet folders(packages);
  PackageHeaders headers(folders);
  std::vector<Inclusion> found;
  TextFiles files([&](const std::string& file) {
    for (const std::string& header : headers.included_by(file))
      if (folders.of(header) != folders.of(file)) found.push_back({file, header});
  });
  for (const std::string& package : packages) files.walk(package);
  return found;
}

std::set<std::string> reached_by_includes(const std::vector<std::string>& packages,
                                          const std::set<std::string>& compiled) {
  PackageHeaders headers{FolderSet(packages)};
  std::set<std::string> reached;
  std::vector<std::string> todo(compiled.begin(), compiled.end());
  while (!todo.empty()) {
    const std::string file = todo.back();
    todo.pop_back();
    if (!reached.insert(file).second) continue;
    for (const std::string& header : headers.included_by(file)) todo.push_back(header);
  }
  return reached;
}

std::vector<std::vector<std::string>> joined_by_headers(const std::vector<std::string>& packages) {
  const FolderSet folders(packages);
  std::map<std::string, std::string> first;  // package -> the one that stands for its set
  for (const std::string& package : packages) first[package] = package;
  for (const Inclusion& inclusion : inclusions_between(packages)) {
    const std::string into = first.at(*folders.of(inclusion.file));
    const std::string from = first.at(*folders.of(inclusion.header));
    for (auto& item : first)
      if (item.second == from) item.second = into;
  }
  std::vector<std::vector<std::string>> sets;
  std::map<std::string, std::size_t> set_of;
  for (const std::string& package : packages) {
    const auto known = set_of.emplace(first.at(package), sets.size());
    if (known.second) sets.emplace_back();
    sets[known.first->second].push_back(package);
  }
  return sets;
}

std::map<std::string, std::string> headers_in_use(const FolderSet& packages, const SearchedFolders& searched,
                                                  const std::vector<Inclusion>& known) {
  PackageHeaders headers(packages);
  std::map<std::string, std::string> users;
  std::vector<std::string> todo;
  const auto use = [&](const std::string& header, const std::string& user) {
    if (users.emplace(header, user).second) todo.push_back(header);
  };
  std::vector<std::string> left_out(packages.begin(), packages.end());
  left_out.insert(left_out.end(), searched.left_out.begin(), searched.left_out.end());
  TextFiles files(
      [&](const std::string& file) {
        for (const std::string& header : headers.included_by(file)) use(header, file);
      },
      FolderSet(left_out));
  for (const std::string& root : searched.roots) files.walk(root);
  for (const Inclusion& inclusion : known) use(inclusion.header, inclusion.file);
  while (!todo.empty()) {
    const std::string header = todo.back();
    todo.pop_back();
    for (const std::string& inner : headers.included_by(header)) use(inner, users.at(header));
  }
  return users;
}

Note note_on_users(const std::string& package_dir, const std::map<std::string, std::string>& users,
                   const std::vector<std::string>& others) {
  std::vector<std::string> stay;
  for (const auto& [header, user] : users)
    if (is_below(header, package_dir))
      stay.push_back(header.substr(package_dir.size() + 1) + " (by " + user + ")");
  std::string text =
      "--exported-headers=change: the workspace, the packages named and the installed packages that "
      "depend on this one are taken for all users of its headers; ";
  if (!others.empty()) text += "solved as one with it: " + listed(others) + "; ";
  if (!stay.empty())
    text += "these headers are included and stay: " + listed(stay);
  else
    text += others.empty() ? "none of them includes one" : "nobody else includes one";
  return {codes::TZC1005, Location{package_dir + "/package.xml", 1, 1}, text};
}

std::optional<Note> note_on_kept_headers(const Report& report) {
  const auto sites = std::count_if(report.sites.begin(), report.sites.end(),
                                   [](const Site& site) { return site.in_exported_header; });
  if (sites == 0) return {};
  const std::string text = fmt::format(
      "{} wait{} for headers that other packages may include: if only packages named in this run do, "
      "--exported-headers=change ports these, too",
      sites == 1 ? "1 site" : fmt::format("{} sites", sites), sites == 1 ? "s" : "");
  return Note{codes::TZC1005, Location{report.package_dir + "/package.xml", 1, 1}, text};
}

SearchedFolders folders_of_users(const std::set<std::string>& packages, const std::string& workspace,
                                 const std::vector<std::string>& named, const std::set<std::string>& shares) {
  SearchedFolders searched{{workspace}, {}};
  searched.roots.insert(searched.roots.end(), named.begin(), named.end());
  const NamedPackages hiding(named);
  for (const std::string& share : shares) {
    const fs::path prefix = fs::path(share) / "..";
    for (const std::string& space : source_spaces(prefix)) {
      searched.roots.push_back(space);
      for (const std::string& folder : hiding.no_users_in(space)) searched.left_out.push_back(folder);
    }
    std::error_code failed;
    for (const auto& entry : fs::directory_iterator(share, failed)) {
      const std::string name = entry.path().filename();
      if (!hiding.has_name(name) && depends_on_any(entry.path() / "package.xml", packages))
        searched.roots.push_back((prefix / "include" / name).string());
    }
  }
  return searched;
}

}  // namespace tzc::rewriter
