// SPDX-License-Identifier: BSD-3-Clause
#include "other_code/package_headers.h"

#include <algorithm>
#include <filesystem>
#include <regex>
#include <sstream>
#include <utility>
#include <vector>

#include "buildfiles/cmake_file.h"
#include "edits/files.h"
#include "edits/links.h"
#include "other_code/text_files.h"

namespace tzc::rewriter {
namespace fs = std::filesystem;
namespace {

/// "../a/./b.h" as "a/b.h": where it is searched from is not known.
std::string without_dots(const std::string& name) {
  fs::path path;
  for (const fs::path& part : fs::path(name).lexically_normal())
    if (part != ".." && part != ".") path /= part;
  return path.string();
}

}  // namespace

PackageHeaders::PackageHeaders(const FolderSet& packages) : packages_(packages) {
  for (const std::string& package : packages)
    for (const auto& [link, target] : links_below(package))
      if (packages.hold(target)) links_.emplace(link, target);
  add_files();
  add_links();
}

void PackageHeaders::add_files() {
  TextFiles files([this](const std::string& file) {
    const auto link = links_.find(file);
    by_name_[fs::path(file).filename()].emplace(file, link == links_.end() ? file : link->second);
  });
  for (const std::string& package : packages_) files.walk(package);
}

/// Each file is visited once, in its own folder.
void PackageHeaders::add_links() {
  std::vector<std::pair<std::string, std::string>> more;
  for (const auto& [link, target] : links_)
    for (const auto& item : by_name_)
      for (const auto& [path, file] : item.second)
        if (is_below(path, target)) more.emplace_back(link + path.substr(target.size()), file);
  for (const auto& [path, file] : more) by_name_[fs::path(path).filename()].emplace(path, file);
}

/// `file`: where the directive stands. A quoted name that is found beside it means that file.
std::set<std::string> PackageHeaders::meant_by(const std::string& name, bool quoted,
                                               const std::string& file) {
  const auto known = by_name_.find(fs::path(name).filename());
  if (known == by_name_.end()) return {};
  if (quoted) {
    const std::string beside = canonical_path((fs::path(file).parent_path() / name).string());
    const bool is_known = std::any_of(known->second.begin(), known->second.end(),
                                      [&](const auto& path) { return path.second == beside; });
    if (is_known) return {beside};
    std::error_code failed;
    if (fs::exists(beside, failed)) return {};
  }
  std::set<std::string> found;
  const std::string end = "/" + without_dots(name);
  for (const auto& [path, header] : known->second)
    if (path.size() > end.size() && path.compare(path.size() - end.size(), end.size(), end) == 0 &&
        is_found(path, end, file))
      found.insert(header);
  return found;
}

/// `name`: with the slash in front of it, the end of the header's path.
bool PackageHeaders::is_found(const std::string& header, const std::string& name, const std::string& file) {
  const std::string& package = *packages_.of(header);
  return packages_.of(file) == &package ||
         folders_.may_serve(header.substr(0, header.size() - name.size()), package, file);
}

std::set<std::string> PackageHeaders::included_by(const std::string& file) {
  static const std::regex directive(R"(^\s*#\s*(?:include|include_next|import)\s*([<"])([^>"]+)[>"])");
  static const std::regex name(
      R"(([<"])([^<>"\s]+)[>"])");  // target_precompile_headers(node PRIVATE <lib/a.h>)
  const bool is_cmake = has_cmake_name(file);
  std::set<std::string> found;
  const Expected<std::string> text = read_file(file);
  std::istringstream stream(text ? *text : "");
  for (std::string line; std::getline(stream, line);) {
    if (!is_cmake && line.find('#') == std::string::npos) continue;
    for (std::sregex_iterator match(line.begin(), line.end(), is_cmake ? name : directive), end; match != end;
         ++match)
      found.merge(meant_by((*match)[2], (*match)[1] == "\"", file));
  }
  return found;
}

}  // namespace tzc::rewriter
