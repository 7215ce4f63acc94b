// SPDX-License-Identifier: BSD-3-Clause
#include "paper/counts.h"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <utility>

#include "paper/tool_tables.h"

namespace tzc {
namespace bench {
namespace {

using nlohmann::json;

constexpr char file[] = "counts.json";

/// What was counted of a folder.
struct Counted {
  std::string folder;  // absolute: the next run may begin elsewhere
  Fields fields;
};

struct CountedRows {
  std::vector<Counted> types, effort;
  Fields all_types;  // of all folders of types together; empty: it was not counted
};

json to_json(const std::vector<Counted>& rows) {
  json all = json::array();
  for (const Counted& row : rows) all.push_back(json{{"folder", row.folder}, {"fields", row.fields}});
  return all;
}

/// Every row has as many fields as the table's heading.
std::vector<Counted> rows_of(const json& all, const Table& heading) {
  std::vector<Counted> rows;
  for (const json& row : all) {
    rows.push_back({row.at("folder").get<std::string>(), row.at("fields").get<Fields>()});
    if (rows.back().fields.size() != heading.columns.size()) throw std::invalid_argument("fields");
  }
  return rows;
}

CountedRows load(const Store& store) {
  if (!store.has(file)) return {};
  const std::string text = store.read(file);
  try {
    const json document = json::parse(text);
    return {rows_of(document.at("types"), types_table({})), rows_of(document.at("effort"), effort_table({})),
            document.at("all_types").get<Fields>()};
  } catch (const std::exception&) {
    throw StoreError(store.path_of(file) +
                     " is not a result of tzc-bench paper: remove it, and give --types and --effort again");
  }
}

void save(const CountedRows& counts, const Store& store) {
  const json document{
      {"types", to_json(counts.types)}, {"effort", to_json(counts.effort)}, {"all_types", counts.all_types}};
  store.write(file, document.dump(2) + "\n");
}

std::string absolute(const std::string& folder) {
  const auto path = std::filesystem::absolute(folder).lexically_normal();
  return (path.has_filename() ? path : path.parent_path()).string();  // "a/" is "a"
}

/// In the place of what was counted of the folder before.
void put(std::vector<Counted>& rows, const std::string& folder, Fields fields) {
  const std::string place = absolute(folder);
  const auto same =
      std::find_if(rows.begin(), rows.end(), [&](const Counted& row) { return row.folder == place; });
  if (same != rows.end())
    same->fields = std::move(fields);
  else
    rows.push_back({place, std::move(fields)});
}

void count_all_types(CountedRows& counts, std::vector<std::string>& said) {
  std::vector<std::string> folders;
  for (const Counted& row : counts.types) folders.push_back(row.folder);
  counts.all_types.clear();
  if (folders.size() < 2) return;
  if (auto fields = count_types("all", folders, said)) counts.all_types = std::move(*fields);
}

void count_types_of(const std::vector<std::string>& folders, CountedRows& counts,
                    std::vector<std::string>& said) {
  bool any = false;
  for (const std::string& folder : folders) {
    auto fields = count_types(folder, {absolute(folder)}, said);
    if (!fields) continue;
    put(counts.types, folder, std::move(*fields));
    any = true;
  }
  if (any) count_all_types(counts, said);
}

void count_effort_of(const std::vector<std::string>& packages, CountedRows& counts,
                     std::vector<std::string>& said) {
  for (const std::string& package : packages)
    if (auto fields = count_effort(package, said)) put(counts.effort, package, std::move(*fields));
}

std::vector<Fields> fields_of(const std::vector<Counted>& rows) {
  std::vector<Fields> all;
  for (const Counted& row : rows) all.push_back(row.fields);
  return all;
}

}  // namespace

std::vector<Section> counted_sections(const Store& store, const PaperOptions& options,
                                      std::vector<std::string>& said) {
  CountedRows counts = load(store);
  count_types_of(options.types, counts, said);
  count_effort_of(options.effort, counts, said);
  if (!options.types.empty() || !options.effort.empty()) save(counts, store);
  std::vector<Fields> types = fields_of(counts.types);
  if (!counts.all_types.empty()) types.push_back(counts.all_types);
  return {types_section(types_table(std::move(types))),
          effort_section(effort_table(fields_of(counts.effort)))};
}

}  // namespace bench
}  // namespace tzc
