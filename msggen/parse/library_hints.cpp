// SPDX-License-Identifier: BSD-3-Clause
#include "parse/library_hints.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "parse/source.h"
#include "parse/text.h"

namespace tzc::msggen {
namespace {

namespace fs = std::filesystem;

void add_messages(const std::string& folder, std::vector<std::string>& names) {
  std::error_code ignored;
  for (fs::directory_iterator it(folder, ignored), end; !ignored && it != end; it.increment(ignored)) {
    if (it->path().extension() == ".msg") names.push_back(it->path().stem().string());
  }
}

bool have_message(const std::vector<std::string>& folders, const std::string& name) {
  return std::any_of(folders.begin(), folders.end(),
                     [&](const std::string& folder) { return is_file(folder + "/" + name + ".msg"); });
}

// Packages with a message of that name, those that the user named first.
std::vector<std::string> packages_with(const std::string& name, const SearchPath& path,
                                       const PackageIndex& installed) {
  std::vector<std::string> result;
  for (const auto& [package, folders] : path) {
    if (have_message(folders, name)) result.push_back(package);
  }
  for (const auto& [package, where] : installed.all()) {
    if (!path.count(package) && have_message(where.message_directories(), name)) result.push_back(package);
  }
  return result;
}

}  // namespace

std::string package_hint(const std::string& package, const SearchPath& path, const PackageIndex& installed,
                         bool installed_was_searched) {
  if (const Package* found = installed.find(package); found && !installed_was_searched) {
    return fmt::format("add -I {}:{}", package, found->message_directories().front());
  }
  std::vector<std::string> names;
  for (const auto& [name, folders] : path) names.push_back(name);
  for (const auto& [name, where] : installed.all()) names.push_back(name);
  const std::string near = nearest(package, names);
  if (!near.empty()) return fmt::format("did you mean {}?", near);
  return fmt::format("it is not on the ROS package path; install it, or say where it is: -I {}:DIR", package);
}

std::string type_hint(const std::string& package, const std::string& name, const KnownPackage& known,
                      const SearchPath& path, const PackageIndex& installed) {
  const auto others = packages_with(name, path, installed);
  if (!others.empty()) return fmt::format("did you mean {}/{}?", others.front(), name);
  std::vector<std::string> names = known.names;
  for (const std::string& folder : known.folders) add_messages(folder, names);
  std::sort(names.begin(), names.end());
  const std::string near = nearest(name, names);
  if (!near.empty()) return fmt::format("did you mean {}?", near);
  if (known.folders.empty())
    return fmt::format("say where the package's definitions are: -I {}:DIR", package);
  return fmt::format("looked for {}.msg in {}", name, fmt::join(known.folders, ", "));
}

}  // namespace tzc::msggen
