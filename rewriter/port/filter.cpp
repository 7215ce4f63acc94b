// SPDX-License-Identifier: BSD-3-Clause
#include "port/filter.h"

#include <fnmatch.h>

#include <map>

namespace tzc::rewriter {
namespace {

using Globs = std::map<std::string, std::vector<std::string>>;

Globs parse(const std::vector<std::string>& values) {
  Globs globs;
  for (const std::string& value : values) {
    const std::size_t equals = value.find('=');
    globs[value.substr(0, equals)].push_back(value.substr(equals + 1));
  }
  return globs;
}

std::string without_slash(const std::string& text) {
  return text.rfind('/', 0) == 0 ? text.substr(1) : text;
}

std::string value_of(const Site& site, const std::string& kind, const FolderSet& packages) {
  if (kind == "type") return site.message_type;
  if (kind == "topic") return without_slash(site.topic.value_or(""));
  return packages.relative(site.where.file);
}

bool matches_one(const std::string& value, const std::vector<std::string>& globs) {
  for (const std::string& glob : globs)
    if (fnmatch(without_slash(glob).c_str(), value.c_str(), 0) == 0) return true;
  return false;
}

}  // namespace

std::string filter_format(const std::string& text) {
  for (const char* kind : {"topic=", "type=", "file="})
    if (text.rfind(kind, 0) == 0 && text.size() > std::string(kind).size()) return "";
  return text + ": write topic=GLOB, type=GLOB or file=GLOB";
}

bool is_file_of(const std::string& file, const std::vector<std::string>& globs, const FolderSet& packages) {
  return matches_one(packages.relative(file), globs);
}

SiteFilter make_filter(const std::vector<std::string>& only, const std::vector<std::string>& except,
                       const FolderSet& packages) {
  if (only.empty() && except.empty()) return {};
  return [only = parse(only), except = parse(except), packages](const Site& site) {
    for (const auto& [kind, globs] : only)
      if (!matches_one(value_of(site, kind, packages), globs)) return false;
    for (const auto& [kind, globs] : except)
      if (matches_one(value_of(site, kind, packages), globs)) return false;
    return true;
  };
}

}  // namespace tzc::rewriter
