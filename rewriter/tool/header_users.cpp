// SPDX-License-Identifier: BSD-3-Clause
#include "tool/header_users.h"

#include <algorithm>
#include <filesystem>
#include <set>
#include <sstream>

#include "buildfiles/package_xml.h"
#include "edits/files.h"
#include "model/codes.h"
#include "tool/package_headers.h"
#include "tool/places.h"
#include "tool/text_files.h"

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

/// Of the packages that the command line names.
std::set<std::string> names_of_packages(const std::vector<std::string>& arguments) {
  std::set<std::string> names;
  for (const std::string& argument : arguments)
    if (const Expected<std::vector<std::string>> folders = find_packages_at(argument))
      for (const std::string& folder : *folders)
        if (const Expected<PackageXml> manifest = read_package_xml(folder)) names.insert(manifest->name);
  return names;
}

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

std::map<std::string, std::string> headers_in_use(const FolderSet& packages,
                                                  const std::vector<std::string>& roots,
                                                  const std::vector<Inclusion>& known) {
  PackageHeaders headers(packages);
  std::map<std::string, std::string> users;
  std::vector<std::string> todo;
  const auto use = [&](const std::string& header, const std::string& user) {
    if (users.emplace(header, user).second) todo.push_back(header);
  };
  for (const Inclusion& inclusion : known) use(inclusion.header, inclusion.file);
  TextFiles files(
      [&](const std::string& file) {
        for (const std::string& header : headers.included_by(file)) use(header, file);
      },
      packages);
  for (const std::string& root : roots) files.walk(root);
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

std::vector<std::string> roots_of_users(const std::set<std::string>& packages, const std::string& workspace,
                                        const std::vector<std::string>& named,
                                        const std::set<std::string>& shares) {
  std::vector<std::string> roots = {workspace};
  roots.insert(roots.end(), named.begin(), named.end());
  const std::set<std::string> hidden = names_of_packages(named);
  for (const std::string& share : shares) {
    const fs::path prefix = fs::path(share) / "..";
    for (const std::string& folder : source_spaces(prefix)) roots.push_back(folder);
    std::error_code failed;
    for (const auto& entry : fs::directory_iterator(share, failed)) {
      const std::string name = entry.path().filename();
      if (hidden.count(name) == 0 && depends_on_any(entry.path() / "package.xml", packages))
        roots.push_back((prefix / "include" / name).string());
    }
  }
  return roots;
}

}  // namespace tzc::rewriter
