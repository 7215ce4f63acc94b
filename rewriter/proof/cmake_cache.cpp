// SPDX-License-Identifier: BSD-3-Clause
#include "proof/cmake_cache.h"

#include <algorithm>
#include <filesystem>
#include <sstream>
#include <utility>

#include "edits/files.h"

namespace tzc::rewriter {
namespace fs = std::filesystem;
namespace {

bool ends_with(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

/// NAME:TYPE=value; a name with a colon stands in quotes.
bool parse_entry(const std::string& line, CacheEntry& entry) {
  if (line.empty() || line[0] == '#' || line[0] == '/') return false;
  const bool quoted = line[0] == '"';
  const std::size_t name_end = quoted ? line.find("\":", 1) : line.find(':');
  if (name_end == std::string::npos) return false;
  const std::size_t type = name_end + (quoted ? 2 : 1);
  const std::size_t equals = line.find('=', type);
  if (equals == std::string::npos) return false;
  entry.name = line.substr(quoted ? 1 : 0, name_end - (quoted ? 1 : 0));
  entry.type = line.substr(type, equals - type);
  entry.value = line.substr(equals + 1);
  return true;
}

}  // namespace

CmakeCache::CmakeCache(std::string folder, const std::string& text) : folder_(std::move(folder)) {
  std::istringstream stream(text);
  CacheEntry entry;
  for (std::string line; std::getline(stream, line);)
    if (parse_entry(line, entry)) entries_.push_back(entry);
}

CmakeCache CmakeCache::nearest(const std::string& folder) {
  for (fs::path at = folder; at.has_relative_path(); at = at.parent_path())
    if (const Expected<std::string> text = read_file(at / "CMakeCache.txt")) return {at, *text};
  return {};
}

std::string CmakeCache::value(const std::string& name) const {
  const auto found = std::find_if(entries_.begin(), entries_.end(),
                                  [&](const CacheEntry& entry) { return entry.name == name; });
  return found == entries_.end() || ends_with(found->value, "NOTFOUND") ? "" : found->value;
}

std::string cache_command(const CacheEntry& entry) {
  static const std::string types[] = {"BOOL", "STRING", "PATH", "FILEPATH"};
  const bool known = std::find(std::begin(types), std::end(types), entry.type) != std::end(types);
  std::string brackets;  // nothing is expanded in a bracket argument
  while (entry.value.find("]" + brackets + "]") != std::string::npos) brackets += "=";
  return "set(" + entry.name + " [" + brackets + "[" + entry.value + "]" + brackets + "] CACHE " +
         (known ? entry.type : "STRING") + " \"\" FORCE)\n";
}

}  // namespace tzc::rewriter
