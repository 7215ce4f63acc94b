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

}  // namespace

Fields types_row(const std::string& name, const std::string& classification) {
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

std::optional<Fields> count_types(const std::string& name, const Names& folders,
                                  std::vector<std::string>& said) {
  Names command{"tzc-msggen", "classify", "--json"};
  command.insert(command.end(), folders.begin(), folders.end());
  const ProgramResult result = run_program(command);
  if (result.status == 0) return types_row(name, result.output);
  said.push_back(reason_of(result, "types of " + name));
  return std::nullopt;
}

Table types_table(std::vector<Fields> rows) {
  return {
      {"folder", "types", "with_variable_array", "percent_of_types", "with_data_part", "percent_of_those"},
      std::move(rows)};
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

std::optional<Fields> count_effort(const std::string& package, std::vector<std::string>& said) {
  const ProgramResult result = run_program({"tzc-rewrite", "--quiet", package});
  if (result.status != 0 && result.status != 1) {
    said.push_back(reason_of(result, "effort of " + package));
    return std::nullopt;
  }
  const DiffSize size = size_of_diff(result.output);
  return Fields{package, std::to_string(size.files), std::to_string(size.added),
                std::to_string(size.removed)};
}

Table effort_table(std::vector<Fields> rows) {
  return {{"package", "files", "lines_added", "lines_removed"}, std::move(rows)};
}

}  // namespace bench
}  // namespace tzc
