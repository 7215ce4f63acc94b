// SPDX-License-Identifier: BSD-3-Clause
#include "engine/engine.h"

#include <atomic>
#include <fstream>
#include <mutex>
#include <regex>
#include <sstream>

#include "buildfiles/cmake_edits.h"
#include "edits/in_parallel.h"
#include "engine/completeness.h"
#include "engine/demotion_loop.h"
#include "engine/notes.h"
#include "engine/pending_sites.h"
#include "engine/read_unit.h"
#include "engine/trusted_functions.h"
#include "model/codes.h"
#include "solve/describe_sites.h"
#include "solve/light_messages.h"

namespace tzc::rewriter {
namespace {

std::optional<std::string> read_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return {};
  std::ostringstream content;
  content << file.rdbuf();
  return content.str();
}

class PortPlanner {
 public:
  PortPlanner(const EngineOptions& options, std::vector<CompileUnit> units, TrustedFunctions trusted)
      : options_(options),
        units_(std::move(units)),
        rules_(all_rules(options.without_rules)),
        trusted_(std::move(trusted)) {}

  Expected<PortPlan> run();

 private:
  std::optional<Error> collect();
  std::optional<Error> sort_out(const CompileUnit& unit, const Diagnostic& error);
  std::vector<std::string> include_dirs() const;
  void step(const std::string& stage, unsigned done, const std::string& what);
  PortPlan finish(const Components& components, DemotionLoop::Result result) const;

  const EngineOptions& options_;
  std::vector<CompileUnit> units_;
  RuleSet rules_;
  TrustedFunctions trusted_;
  UnitReading reading_;
  std::vector<CompileUnit> parsed_;
  std::vector<Note> left_out_;  ///< units that do not parse
};

/// In the words of Clang or GCC.
bool misses_header(const std::string& error) {
  return error.find("file not found") != std::string::npos ||
         error.find("No such file or directory") != std::string::npos;
}

Error does_not_parse(const Diagnostic& error, const CompileUnit& unit) {
  const std::string where = error.where.file.empty() || error.where.line == 0
                                ? unit.file
                                : error.where.file + ":" + std::to_string(error.where.line);
  return {"does not parse: " + error.text, where,
          (misses_header(error.text)
               ? "Build the package first (generated headers must be there), then run again; "
               : "Clang must accept each unit, as the package's compiler does; repair it or leave the unit "
                 "out of the build; ") +
              unit.file + " was being read."};
}

/// Folders of headers that other packages may include.
std::set<std::string> exported_dirs(const std::string& package_dir) {
  const Expected<CmakeProject> project = load_cmake_project(package_dir);
  return project ? exported_folders(*project, package_dir) : std::set<std::string>();
}

/// Lines that look like a site, for a file that was not parsed.
std::string lines_with_sites(const std::string& file) {
  static const std::regex site("\\b(publish|advertise|subscribe)\\w*\\s*[<(]");
  std::istringstream stream(read_file(file).value_or(""));
  std::string lines, line;
  for (unsigned number = 1; std::getline(stream, line); ++number)
    if (std::regex_search(line, site)) lines += (lines.empty() ? "" : ", ") + std::to_string(number);
  return lines;
}

void PortPlanner::step(const std::string& stage, unsigned done, const std::string& what) {
  if (options_.progress) options_.progress->step(stage, done, static_cast<unsigned>(units_.size()), what);
}

/// TZC's headers and those of the package's own messages, in one order for every parse.
std::vector<std::string> PortPlanner::include_dirs() const {
  std::vector<std::string> dirs = options_.extra_include_dirs;
  if (!options_.tzc_include.empty()) dirs.push_back(options_.tzc_include);
  return dirs;
}

/// A unit that does not parse is left out when the package's compiler rejects it, too: then it is not part of
/// the build. Otherwise it is an error.
std::optional<Error> PortPlanner::sort_out(const CompileUnit& unit, const Diagnostic& error) {
  if (options_.strict || !options_.judges.original_errors) return does_not_parse(error, unit);
  const Expected<std::vector<CompilerError>> errors = options_.judges.original_errors(unit.file);
  if (!errors || errors->empty()) return does_not_parse(error, unit);
  const std::string sites = lines_with_sites(unit.file);
  left_out_.push_back(
      {codes::TZC3003, Location{unit.file, 1, 1},
       "the package's own compiler refuses it, too, so it was not looked at: " + errors->front().text +
           (sites.empty() ? "; it seems to hold no site" : "; possible sites in lines " + sites)});
  return {};
}

std::optional<Error> PortPlanner::collect() {
  std::vector<UnitReading> readings(units_.size());
  std::optional<Error> failure;
  std::mutex mutex;
  std::atomic<bool> failed{false};  // what remains need not be read: large packages take minutes
  unsigned done = 0;
  CollectOptions options{
      options_.package_dir,
      options_.build_dir,
      options_.headers_in_use ? *options_.headers_in_use : exported_dirs(options_.package_dir),
      &rules_,
      include_dirs(),
      trusted_};
  in_parallel(options_.jobs, units_.size(), [&](std::size_t i) {
    if (failed) return;
    readings[i] = read_unit(units_[i], options, options_.accesses);
    const std::vector<Diagnostic>& errors = readings[i].errors;
    const std::lock_guard<std::mutex> lock(mutex);
    if (!errors.empty() && !failure) failure = sort_out(units_[i], errors.front());
    failed = failure.has_value();
    step("parsing", ++done, units_[i].file);
  });
  for (std::size_t i = 0; i < units_.size(); ++i) {
    if (!readings[i].errors.empty()) continue;
    parsed_.push_back(units_[i]);
    reading_.merge(std::move(readings[i]));
  }
  leave_light_types(reading_.facts, options_.small);
  if (!failure && parsed_.empty())
    failure =
        Error{"no unit of the package compiles: " + left_out_.front().text, left_out_.front().where->file,
              misses_header(left_out_.front().text)
                  ? "Build the package first (generated headers must be there), then run again."
                  : "Repair the package until its own compiler accepts it, then run again."};
  return failure;
}

PortPlan PortPlanner::finish(const Components& components, DemotionLoop::Result result) const {
  PortPlan plan;
  plan.edits = std::move(result.plan.edits);
  plan.contents = result.contents;
  for (const auto& item : result.plan.headers)
    plan.needed_headers.insert(item.second.begin(), item.second.end());
  plan.report.package_dir = options_.package_dir;
  plan.report.package = options_.package_dir.substr(options_.package_dir.find_last_of('/') + 1);
  plan.report.sites = describe_sites(reading_.facts, components, options_, result.solution);
  mark_pending(plan.report.sites, reading_.facts, components, plan.edits);
  plan.report.notes = notes_of(reading_, units_, options_);
  plan.report.notes.insert(plan.report.notes.end(), left_out_.begin(), left_out_.end());
  for (const std::string& header : plan.needed_headers)
    if (const std::size_t slash = header.find('/', 4); slash != std::string::npos)
      plan.tzc_types.insert(header.substr(4, header.size() - 6));
  for (const auto& item : reading_.facts.units_of_file) plan.parsed_files.push_back(item.first);
  for (const auto& item : result.contents) {
    const auto units = reading_.facts.units_of_file.find(item.first);
    if (units != reading_.facts.units_of_file.end())
      plan.ported_targets_files.insert(units->second.begin(), units->second.end());
  }
  return plan;
}

Expected<PortPlan> PortPlanner::run() {
  if (std::optional<Error> failure = collect()) return *failure;
  const Components components(reading_.facts, options_.without_rules.count("all-or-nothing") == 0);
  ParseOptions parse_options;
  parse_options.include_dirs = include_dirs();
  parse_options.accesses = options_.accesses;
  Verifier verifier({parsed_, reading_.facts, reading_.calls, components, options_.package_dir},
                    parse_options, options_.jobs, read_file, options_.judges);
  const UnseenBranches unseen(reading_.skipped, reading_.facts, components, read_file);
  Expected<DemotionLoop::Result> result =
      DemotionLoop(reading_.facts, components, options_, unseen, verifier, read_file).run();
  if (!result) return result.error();
  PortPlan plan = finish(components, std::move(*result));
  if (options_.without_rules.count("completeness")) return plan;
  if (Expected<void> complete = check_complete(plan.report, reading_.api_calls); !complete)
    return complete.error();
  return plan;
}

}  // namespace

Expected<PortPlan> plan_port(const EngineOptions& options) {
  Expected<std::vector<CompileUnit>> units = load_units(options.package_dir, options.build_dir);
  if (!units) return units.error();
  Expected<TrustedFunctions> trusted = load_trusted_functions(options.package_dir);
  if (!trusted) return trusted.error();
  return PortPlanner(options, std::move(*units), std::move(*trusted)).run();
}

}  // namespace tzc::rewriter
