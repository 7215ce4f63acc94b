// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "edits/diff.h"
#include "report/model.h"

namespace tzc::rewriter {

/// A file that the port changes.
struct FileChange {
  std::string path;  ///< relative to the package
  std::string before, after;
};

struct PackageReport {
  Report report;
  std::vector<FileChange> changes;
  DiffStat stat() const;
};
using RunReport = std::vector<PackageReport>;

struct TextStyle {
  bool colour = false;
  bool chains = true;  ///< the flow that led to each remark
};

/// For a terminal: the sites as a table, remarks with their reason, a summary.
std::string to_text(const PackageReport& package, const TextStyle& style);

/// One package: {"version": 1, "package", "sites", "notes", "summary"}; several: {"version": 1, "packages":
/// [those]}.
std::string to_json(const RunReport& run);

/// SARIF 2.1.0, one result for each remark and note.
std::string to_sarif(const RunReport& run, const std::string& tool_version);

/// One page that needs nothing else: summary, sites with their flow, side-by-side diff.
std::string to_html(const RunReport& run);

/// A site that stays on TCPROS, though neither a comment nor an option of the run wants it so: work is left.
bool is_refusal(const Site& site);

/// The chain without a single step that only repeats the reason.
std::vector<FlowStep> shown_chain(const Site& site);

/// The site's file relative to the package.
std::string relative_file(const Report& report, const std::string& file);

const char* name_of(SiteKind kind);
const char* name_of(Level level);

/// The levels that a kind of site can have, the best first.
std::vector<Level> levels_of(SiteKind kind);
unsigned count(const Report& report, SiteKind kind, Level level);

}  // namespace tzc::rewriter
