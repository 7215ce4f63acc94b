// SPDX-License-Identifier: BSD-3-Clause
#include "report/sarif_fix.h"

#include "report/utf16.h"

namespace tzc::rewriter {
namespace {

using json = nlohmann::ordered_json;
using Lines = std::vector<DiffLine>;

bool ends_line(std::string_view text) {
  return !text.empty() && text.back() == '\n';
}

/// A run of removed and added lines as one replacement; `at` ends behind it. `line` is the number of the next line
/// of the old text.
json replacement(const Lines& lines, std::size_t& at, unsigned line) {
  json region = {{"startLine", line}, {"startColumn", 1}, {"endLine", line}, {"endColumn", 1}};
  std::string inserted;
  for (; at < lines.size() && lines[at].change != LineChange::same; ++at) {
    if (lines[at].change == LineChange::added) {
      inserted += lines[at].text;
    } else if (ends_line(lines[at].text)) {
      region["endLine"] = ++line;
    } else {
      region["endColumn"] = utf16_length(lines[at].text) + 1;
    }
  }
  json object = {{"deletedRegion", region}};
  if (!inserted.empty()) object["insertedContent"] = {{"text", inserted}};
  return object;
}

json replacements(const FileChange& change) {
  const Lines lines = diff_lines(change.before, change.after);
  json all = json::array();
  unsigned line = 1;
  for (std::size_t at = 0; at < lines.size();) {
    if (lines[at].change != LineChange::same) {
      const std::size_t begin = at;
      all.push_back(replacement(lines, at, line));
      for (std::size_t i = begin; i < at; ++i) line += lines[i].change == LineChange::removed;
    } else {
      ++line;
      ++at;
    }
  }
  return all;
}

}  // namespace

json sarif_fixes(const PackageReport& package, const SarifPlaces& places) {
  json changes = json::array();
  for (const FileChange& change : package.changes)
    changes.push_back(
        {{"artifactLocation", places.artifact(package, package.report.package_dir + "/" + change.path)},
         {"replacements", replacements(change)}});
  const std::string text = "Port the package " + package.report.package + " to TZC";
  return json::array({{{"description", {{"text", text}}}, {"artifactChanges", changes}}});
}

}  // namespace tzc::rewriter
