// SPDX-License-Identifier: BSD-3-Clause
#include "paper/tool_tables.h"

#include <fmt/format.h>

#include <sstream>
#include <tuple>
#include <utility>

#include "paper/program.h"

namespace tzc {
namespace bench {
namespace {

using Names = std::vector<std::string>;

std::string share(std::size_t part, std::size_t whole) {
  return whole > 0 ? fmt::format("{:.1f}", 100.0 * static_cast<double>(part) / static_cast<double>(whole))
                   : "";
}

bool begins(const std::string& text, const char* prefix) {
  return text.rfind(prefix, 0) == 0;
}

std::string reason_of(const ProgramResult& result, const std::string& about) {
  const std::string said = result.error.substr(0, result.error.find('\n'));
  return fmt::format("{}: {}; left out", about,
                     said.empty() ? fmt::format("status {}", result.status) : said);
}

/// "-12,3": 3; "-12": 1.
std::size_t length_of_range(const std::string& range) {
  const std::size_t comma = range.find(',');
  return comma == std::string::npos ? 1 : std::stoul(range.substr(comma + 1));
}

/// "@@ -12,3 +12,4 @@": 3 lines before, 4 after.
std::pair<std::size_t, std::size_t> lengths_of_hunk(const std::string& heading) {
  std::istringstream words(heading);
  std::string at, before, after;
  words >> at >> before >> after;
  return {length_of_range(before), length_of_range(after)};
}

/// tzc-msggen's classification of all folders; empty, and a reason, when it fails.
std::string classification_of(const Names& folders, std::vector<std::string>& said) {
  Names command{"tzc-msggen", "classify", "--json"};
  command.insert(command.end(), folders.begin(), folders.end());
  const ProgramResult result = run_program(command);
  if (result.status == 0) return result.output;
  said.push_back(reason_of(result, "types of " + folders.front()));
  return "";
}

}  // namespace

std::vector<std::string> types_row(const std::string& name, const std::string& classification) {
  const auto totals = nlohmann::json::parse(classification).at("totals");
  const std::size_t types = totals.at("types"), variable = totals.at("has_variable_array"),
                    data = totals.at("has_data_part");
  return {name,
          std::to_string(types),
          std::to_string(variable),
          share(variable, types),
          std::to_string(data),
          share(data, variable)};
}

Table types_table(const Names& folders, std::vector<std::string>& said) {
  Table table{
      {"folder", "types", "with_variable_array", "percent_of_types", "with_data_part", "percent_of_those"},
      {}};
  Names readable;
  for (const std::string& folder : folders) {
    const std::string classification = classification_of({folder}, said);
    if (classification.empty()) continue;
    readable.push_back(folder);
    table.rows.push_back(types_row(folder, classification));
  }
  if (readable.size() < 2) return table;
  const std::string all = classification_of(readable, said);
  if (!all.empty()) table.rows.push_back(types_row("all", all));
  return table;
}

// Only what a hunk's heading promises is content: a line of it may begin with "---", too.
DiffSize size_of_diff(const std::string& diff) {
  DiffSize size;
  std::istringstream lines(diff);
  std::size_t before = 0, after = 0;  // lines of the hunk that are still to come
  for (std::string line; std::getline(lines, line);) {
    if (before == 0 && after == 0) {
      size.files += begins(line, "+++ ") ? 1 : 0;
      if (begins(line, "@@ -")) std::tie(before, after) = lengths_of_hunk(line);
      continue;
    }
    const bool added = begins(line, "+"), removed = begins(line, "-"), remark = begins(line, "\\");
    size.added += added ? 1 : 0;
    size.removed += removed ? 1 : 0;
    if (!added && !remark && before > 0) --before;
    if (!removed && !remark && after > 0) --after;
  }
  return size;
}

Table effort_table(const Names& packages, std::vector<std::string>& said) {
  Table table{{"package", "files", "lines_added", "lines_removed"}, {}};
  for (const std::string& package : packages) {
    const ProgramResult result = run_program({"tzc-rewrite", "--quiet", package});
    if (result.status != 0 && result.status != 1) {
      said.push_back(reason_of(result, "effort of " + package));
      continue;
    }
    const DiffSize size = size_of_diff(result.output);
    table.rows.push_back(
        {package, std::to_string(size.files), std::to_string(size.added), std::to_string(size.removed)});
  }
  return table;
}

}  // namespace bench
}  // namespace tzc
