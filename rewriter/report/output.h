// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "edits/diff.h"
#include "model/report.h"

namespace tzc::rewriter {

/// A file that the port changes.
struct FileChange {
  std::string path;  ///< relative to the package
  std::string before, after;
};

/// A place that the port would change: why a check fails where nothing stands in the way.
struct PendingPlace {
  std::string code;
  Location where;
  std::string text;
  std::string site_id;  ///< empty: it belongs to no site, as an edit of a build file alone
};

struct PackageReport {
  Report report;
  std::vector<FileChange> changes;
  bool written = false;  ///< the changes are in the files, or in a copy; otherwise they are only shown
  std::vector<PendingPlace> pending;
  std::string source_root;  ///< what code scanning takes paths from: the repository's top; empty: the package
  std::string commit;       ///< of the package's repository; empty: there is none
  std::map<std::string, std::uint64_t>
      message_sizes;  ///< topic -> bytes of the largest message of a recording
  DiffStat stat() const;
};
using RunReport = std::vector<PackageReport>;

struct TextStyle {
  bool colour = false;
  bool chains = true;  ///< the flow that led to each remark
};

/// For a terminal: the sites as a table, remarks with their reason, a summary.
std::string to_text(const PackageReport& package, const TextStyle& style);

/// The sites of a package in a few words: "publish: 2 zero_copy, 1 plain; subscribe: 1 shared".
std::string in_one_line(const Report& report);

/// One package: {"version": 1, "package", "sites", "notes", "summary"}; several: {"version": 1, "packages":
/// [those]}.
std::string to_json(const RunReport& run);

/// SARIF 2.1.0, one result for each remark, note and pending place. Those that the port would change carry it as
/// their fix.
std::string to_sarif(const RunReport& run, const std::string& tool_version);

/// Where a report comes from, as its reader is told; each may be empty.
struct RunInfo {
  std::string version, date, command;
};

/// One page that needs nothing else: totals, what the port buys, sites with their flow and filters, side-by-side diff.
/// Valid UTF-8, whatever the sources are.
std::string to_html(const RunReport& run, const RunInfo& info);

/// Work is left: the site stays on TCPROS, and no comment and no option of the run asks for that.
bool is_refusal(const Site& site);

/// The chain; of a single step that only repeats the reason no more than its place, and nothing where that is the site's line.
std::vector<FlowStep> shown_flow_path(const Site& site);

/// The site's file relative to the package.
std::string relative_file(const Report& report, const std::string& file);

const char* name_of(SiteKind kind);
const char* name_of(Level level);

/// The levels that a kind of site can have, the best first.
std::vector<Level> levels_of(SiteKind kind);
unsigned count(const Report& report, SiteKind kind, Level level);

}  // namespace tzc::rewriter
