// SPDX-License-Identifier: BSD-3-Clause
#include "report/sarif_places.h"

#include <algorithm>

#include "edits/files.h"
#include "report/utf16.h"

namespace tzc::rewriter {
namespace {

using json = nlohmann::ordered_json;

/// Percent-encoded as RFC 3986 wants paths.
std::string as_uri(const std::string& path) {
  static const std::string plain = "-._~/";
  std::string uri;
  for (const char c : path) {
    const auto byte = static_cast<unsigned char>(c);
    const bool keep = (byte < 128 && std::isalnum(byte)) || plain.find(c) != std::string::npos;
    uri += keep ? std::string(1, c)
                : std::string("%") + "0123456789ABCDEF"[byte >> 4] + "0123456789ABCDEF"[byte & 15];
  }
  return uri;
}

std::string root_of(const PackageReport& package) {
  return package.source_root.empty() ? package.report.package_dir : package.source_root;
}

/// A file as it was analysed: a port that was written has changed it since. Empty when it cannot be read.
std::string source_of(const PackageReport& package, const std::string& file) {
  for (const FileChange& change : package.changes)
    if (package.report.package_dir + "/" + change.path == file) return change.before;
  const Expected<std::string> text = read_file(file);
  return text ? *text : "";
}

/// SRCROOT; a run over several repositories has SRCROOT2 and so on besides.
std::string base_id(std::size_t index) {
  return index == 0 ? "SRCROOT" : "SRCROOT" + std::to_string(index + 1);
}

}  // namespace

SarifPlaces::SarifPlaces(const RunReport& run) {
  for (const PackageReport& package : run)
    if (std::find(roots_.begin(), roots_.end(), root_of(package)) == roots_.end())
      roots_.push_back(root_of(package));
}

json SarifPlaces::artifact(const PackageReport& package, const std::string& file) const {
  const std::string root = root_of(package);
  if (!is_below(file, root)) return {{"uri", "file://" + as_uri(file)}};
  const auto index = std::find(roots_.begin(), roots_.end(), root) - roots_.begin();
  return {{"uri", as_uri(file.substr(root.size() + 1))},
          {"uriBaseId", base_id(static_cast<std::size_t>(index))}};
}

json SarifPlaces::location(const PackageReport& package, const Location& where) const {
  json physical = {{"artifactLocation", artifact(package, where.file)}};
  if (where.line > 0) {
    const unsigned column = utf16_column(source_of(package, where.file), where.line, where.column);
    physical["region"] = {{"startLine", where.line}, {"startColumn", std::max(1u, column)}};
  }
  return {{"physicalLocation", physical}};
}

json SarifPlaces::bases() const {
  json all = json::object();
  for (std::size_t i = 0; i < roots_.size(); ++i)
    all[base_id(i)] = {{"uri", "file://" + as_uri(roots_[i]) + "/"}};
  return all;
}

}  // namespace tzc::rewriter
