// SPDX-License-Identifier: BSD-3-Clause
#include "engine.h"

#include <atomic>
#include <fstream>
#include <mutex>
#include <sstream>

#include "facts/collect_unit.h"
#include "facts/parse.h"
#include "report/codes.h"
#include "solve/notes.h"
#include "verify/demote.h"

namespace tzc::rewriter {
namespace {

std::optional<std::string> read_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return {};
  std::ostringstream content;
  content << file.rdbuf();
  return content.str();
}

class Engine {
 public:
  Engine(const EngineOptions& options, std::vector<CompileUnit> units, RuleSet rules)
      : options_(options), units_(std::move(units)), rules_(std::move(rules)) {}

  Expected<PortPlan> run();

 private:
  std::optional<Error> collect();
  void step(const std::string& stage, unsigned done, const std::string& what);
  PortPlan finish(Porter::Result result) const;

  const EngineOptions& options_;
  std::vector<CompileUnit> units_;
  RuleSet rules_;
  Facts facts_;
};

Error does_not_parse(const Diagnostic& error, const CompileUnit& unit) {
  const std::string where = error.where.file.empty() || error.where.line == 0
                                ? unit.file
                                : error.where.file + ":" + std::to_string(error.where.line);
  return {"does not parse: " + error.text, where,
          "Build the package first (generated headers must be there), then run again; " + unit.file +
              " was being read."};
}

void Engine::step(const std::string& stage, unsigned done, const std::string& what) {
  if (options_.progress) options_.progress->step(stage, done, static_cast<unsigned>(units_.size()), what);
}

std::optional<Error> Engine::collect() {
  std::vector<Facts> facts(units_.size());
  std::optional<Error> failure;
  std::mutex mutex;
  std::atomic<bool> failed{false};  // what remains need not be read: large packages take minutes
  unsigned done = 0;
  CollectOptions options{
      options_.package_dir, options_.build_dir, exported_dirs(options_.package_dir), &rules_, {}};
  options.include_dirs = options_.extra_include_dirs;
  if (!options_.tzc_include.empty()) options.include_dirs.push_back(options_.tzc_include);
  in_parallel(options_.jobs, units_.size(), [&](std::size_t i) {
    if (failed) return;
    std::vector<Diagnostic> errors = collect_unit(units_[i], options, facts[i]);
    const std::lock_guard<std::mutex> lock(mutex);
    if (!errors.empty() && !failure) failure = does_not_parse(errors.front(), units_[i]);
    failed = failure.has_value();
    step("parsing", ++done, units_[i].file);
  });
  for (Facts& of_unit : facts) facts_.merge(std::move(of_unit));
  return failure;
}

PortPlan Engine::finish(Porter::Result result) const {
  PortPlan plan;
  plan.edits = std::move(result.plan.edits);
  plan.needed_headers = std::move(result.plan.headers);
  plan.report.package_dir = options_.package_dir;
  plan.report.package = options_.package_dir.substr(options_.package_dir.find_last_of('/') + 1);
  plan.report.sites = std::move(result.solution.sites);
  plan.report.notes = notes_of(facts_, units_, options_);
  for (const std::string& header : plan.needed_headers)
    if (const std::size_t slash = header.find('/', 4); slash != std::string::npos)
      plan.tzc_types.insert(header.substr(4, header.size() - 6));
  for (const auto& item : facts_.units_of_file) plan.parsed_files.push_back(item.first);
  for (const auto& item : result.contents) {
    const auto units = facts_.units_of_file.find(item.first);
    if (units != facts_.units_of_file.end())
      plan.ported_targets_files.insert(units->second.begin(), units->second.end());
  }
  return plan;
}

Expected<PortPlan> Engine::run() {
  if (std::optional<Error> failure = collect()) return *failure;
  const Components components(facts_, options_.without_rules.count("all-or-nothing") == 0);
  ParseOptions parse_options;
  if (!options_.tzc_include.empty()) parse_options.include_dirs.push_back(options_.tzc_include);
  for (const std::string& dir : options_.extra_include_dirs) parse_options.include_dirs.push_back(dir);
  const Verifier verifier(units_, facts_, components, parse_options, options_.package_dir, options_.jobs,
                          read_file);
  Expected<Porter::Result> result = Porter(facts_, components, options_, verifier, read_file).run();
  if (!result) return result.error();
  PortPlan plan = finish(std::move(*result));
  if (options_.without_rules.count("completeness")) return plan;
  if (Expected<void> complete = check_complete(plan.report, facts_.api_calls); !complete)
    return complete.error();
  return plan;
}

}  // namespace

Expected<PortPlan> plan_port(const EngineOptions& options) {
  Expected<std::vector<CompileUnit>> units = load_units(options.package_dir, options.build_dir);
  if (!units) return units.error();
  return Engine(options, std::move(*units), all_rules(options.without_rules)).run();
}

}  // namespace tzc::rewriter
