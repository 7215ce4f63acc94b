// SPDX-License-Identifier: BSD-3-Clause
// tzc-rewrite with a planner that does as PACKAGE/plan.json says instead of analysing anything:
//   {"edits": [{"file", "find", "replace"}], "sites": [{"id", "kind", "file", "line", "type", "topic",
//   "level", "code"}],
//    "error": "...", "touch": "file to change while analysing", "echo": true, "progress": 3,
//    "throws": "as a system_error", "reads": [absolute paths], "unread": [files that the package's compiler refuses]}
#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <system_error>

#include "edits/apply.h"
#include "edits/files.h"
#include "model/codes.h"
#include "report/output.h"
#include "tool/run.h"

namespace tzc::rewriter {
namespace {

using nlohmann::json;

template <class Enum>
Enum named(const std::string& name, std::initializer_list<Enum> all) {
  for (const Enum value : all)
    if (name == name_of(value)) return value;
  return *all.begin();
}

Site site_of(const json& entry, const std::string& package_dir) {
  Site site;
  site.kind =
      named(entry.value("kind", "publish"), {SiteKind::publish, SiteKind::advertise, SiteKind::subscribe});
  site.where = {package_dir + "/" + entry.value("file", "src/node.cpp"), entry.value("line", 1u), 3};
  site.message_type = entry.value("type", "sensor_msgs/Image");
  site.id = entry.value("id", "site");
  if (entry.contains("topic")) site.topic = entry["topic"];
  site.level = named(entry.value("level", "zero_copy"), {Level::zero_copy, Level::one_copy, Level::plain,
                                                         Level::not_needed, Level::shared, Level::copied});
  site.code = entry.value("code", "");
  site.pending = entry.value("pending", site.level != Level::plain && site.level != Level::not_needed);
  return site;
}

void add_edit(const json& entry, const std::string& package_dir, PortPlan& plan) {
  const std::string file = package_dir + "/" + entry.at("file").get<std::string>();
  const std::string wanted = entry.at("find");
  const std::size_t at = read_file(file)->find(wanted);
  if (at != std::string::npos)
    plan.edits.push_back({file, at, wanted.size(), entry.at("replace"), ComponentId(), "fake"});
  plan.ported_targets_files.insert(file);
}

void show(const EngineOptions& options) {
  fmt::print(stderr, "engine: level={} on_exhausted={} mem_size={} dual={} jobs={} measured={} small={}\n",
             name_of(options.max_level), static_cast<int>(options.on_exhausted), options.mem_size.value_or(0),
             options.dual, options.jobs, options.measured_sizes.size(), options.small);
  if (options.others.headers_in_use)
    for (const std::string& header : *options.others.headers_in_use)
      fmt::print(stderr, "in use: {}\n", header);
  for (const std::string& folder : options.extra_include_dirs)
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
      if (entry.is_regular_file())
        fmt::print(stderr, "twin: {}\n", entry.path().string().substr(folder.size()));
}

std::string fake_digest(std::string_view text) {
  return fmt::format("{:016x}-{}", content_hash(text), text.size());
}

Expected<PortPlan> fake_plan(const EngineOptions& options, const std::string& package_dir) {
  PortPlan plan;
  std::ifstream file(package_dir + "/plan.json");
  const json script = json::parse(file);
  if (script.contains("error")) return Error{script["error"], package_dir + "/src/node.cpp:3", "repair it"};
  if (script.contains("throws"))
    throw std::system_error(std::make_error_code(std::errc::permission_denied), script["throws"]);
  if (script.contains("echo")) show(options);
  for (const std::string& file : script.value("reads", std::vector<std::string>()))
    if (options.accesses) options.accesses->note(file);
  const unsigned units = script.value("progress", 0u);
  for (unsigned i = 1; options.progress && i <= units; ++i)
    options.progress->step("parsing", i, units, "node.cpp");
  for (const json& entry : script.value("edits", json::array())) add_edit(entry, package_dir, plan);
  for (const json& entry : script.value("sites", json::array())) {
    const Site site = site_of(entry, package_dir);
    if (!options.wanted || options.wanted(site)) plan.report.sites.push_back(site);
  }
  for (const std::string& file : script.value("unread", std::vector<std::string>()))
    plan.report.notes.push_back({codes::TZC3003, Location{package_dir + "/" + file, 1, 1}, "refused"});
  for (const auto& [file, edits] : by_file(plan.edits)) {
    Expected<std::string> text = apply_edits(*read_file(file), edits);
    if (text) text = options.judges.written_text(file, *read_file(file), *text);
    if (!text) return text.error();
    plan.contents[file] = *text;
  }
  for (const json& name : script.value("joined", json::array()))
    plan.joined.insert(std::filesystem::path(package_dir).parent_path() / name.get<std::string>());
  const json includes = script.value("includes", json::object());
  for (const auto& [name, units] : includes.items())
    for (const json& unit : units)
      plan.units_of_file[package_dir + "/" + name].insert(std::filesystem::path(package_dir).parent_path() /
                                                          unit.get<std::string>());
  if (script.contains("touch"))
    std::ofstream(package_dir + "/" + script["touch"].get<std::string>(), std::ios::app) << "// changed\n";
  return plan;
}

/// Each package as its plan.json says.
Expected<PortPlans> fake_plans(const EngineOptions& options) {
  PortPlans plans;
  UnitsOfFile units_of_file;
  for (const std::string& package : options.packages) {
    Expected<PortPlan> plan = fake_plan(options, package);
    if (!plan) return plan.error();
    units_of_file.insert(plan->units_of_file.begin(), plan->units_of_file.end());
    plans.emplace(package, std::move(*plan));
  }
  if (options.others.more_headers_in_use) options.others.more_headers_in_use(units_of_file);
  return plans;
}

}  // namespace
}  // namespace tzc::rewriter

int main(int argc, char** argv) {
  return tzc::rewriter::tool_main(argc, argv, {tzc::rewriter::fake_plans, {}, tzc::rewriter::fake_digest});
}
