// SPDX-License-Identifier: BSD-3-Clause
#include "engine/engine.h"

#include <algorithm>
#include <atomic>
#include <fstream>
#include <limits>
#include <map>
#include <mutex>
#include <numeric>
#include <sstream>

#include "buildfiles/build_trees.h"
#include "buildfiles/cmake_edits.h"
#include "buildfiles/unread_files.h"
#include "edits/in_parallel.h"
#include "engine/completeness.h"
#include "engine/debug_builds.h"
#include "engine/demotion_loop.h"
#include "engine/notes.h"
#include "engine/other_code.h"
#include "engine/pending_sites.h"
#include "engine/plan_splitter.h"
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
  explicit PortPlanner(const EngineOptions& options)
      : options_(options), rules_(all_rules(options.without_rules)) {}

  Expected<PortPlans> run();

 private:
  Expected<void> load();
  std::optional<Error> collect();
  std::optional<Error> read(const std::vector<std::size_t>& units, const CollectOptions& options,
                            const std::string& stage);
  std::vector<std::size_t> add_debug_builds();
  std::vector<std::size_t> units_of_more_headers_in_use(CollectOptions& options) const;
  std::optional<Error> lacks_units() const;
  std::optional<Error> sort_out(std::size_t index);
  std::vector<Note> notes_on_left_out() const;
  std::vector<std::string> include_dirs() const;
  void step(const std::string& stage, unsigned done, std::size_t of, const std::string& what);
  UnseenCode unseen_code() const;
  PortPlans finish(const Components& components, DemotionLoop::Result result) const;

  const EngineOptions& options_;
  std::vector<CompileUnit> units_;
  UnitOwners owners_;
  RuleSet rules_;
  TrustedFunctions trusted_;
  std::vector<UnitReading> readings_;   ///< of units_
  UnitReading reading_;                 ///< of all together
  std::set<std::string> debug_builds_;  ///< ids of units that nobody has compiled so
  std::vector<CompileUnit> parsed_;
  std::map<std::size_t, Note> left_out_;  ///< units that do not parse, by their index
  std::set<std::string> exported_;        ///< headers, or folders of headers, that other packages may include
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

Error defect(const Diagnostic& crash, const CompileUnit& unit) {
  return {
      crash.text, unit.file,
      "this is a defect of tzc-rewrite, please report it with this file; nothing of the package was written"};
}

/// Folders of headers that other packages may include.
std::set<std::string> exported_dirs(const FolderSet& packages) {
  std::set<std::string> folders;
  for (const std::string& package : packages)
    if (const Expected<CmakeProject> project = load_cmake_project(package))
      folders.merge(exported_folders(*project, package));
  return folders;
}

FolderSet generated_in_packages(const EngineOptions& options) {
  std::vector<std::string> folders;
  for (const auto& [package, build_dir] : options.build_dirs)
    for (const std::string& folder : generated_folders(build_dir, package)) folders.push_back(folder);
  return FolderSet(std::move(folders));
}

void PortPlanner::step(const std::string& stage, unsigned done, std::size_t of, const std::string& what) {
  if (options_.progress) options_.progress->step(stage, done, static_cast<unsigned>(of), what);
}

/// TZC's headers and those of the package's own messages, in one order for every parse.
std::vector<std::string> PortPlanner::include_dirs() const {
  std::vector<std::string> dirs = options_.extra_include_dirs;
  if (!options_.tzc_include.empty()) dirs.push_back(options_.tzc_include);
  return dirs;
}

/// A unit that does not parse is left out when the package's compiler rejects it, too: then it is not part of
/// the build. Otherwise it is an error.
std::optional<Error> PortPlanner::sort_out(std::size_t index) {
  const CompileUnit& unit = units_[index];
  const UnitReading& reading = readings_[index];
  if (debug_builds_.count(unit.id()) != 0) return {};  // there is no debug build that a port could break
  const Diagnostic& error = reading.errors.front();
  if (reading.crashed) return defect(error, unit);
  if (options_.strict || !options_.judges.original_errors) return does_not_parse(error, unit);
  const Expected<std::vector<CompilerError>> errors = options_.judges.original_errors(unit.file);
  if (!errors || errors->empty()) return does_not_parse(error, unit);
  const std::string sites = lines_with_sites(unit.file);
  Note note{codes::TZC3003, Location{unit.file, 1, 1},
            "the package's own compiler refuses it, too, so it was not looked at: " + errors->front().text +
                (sites.empty() ? "; it seems to hold no site" : "; possible sites in lines " + sites)};
  left_out_.insert_or_assign(index, std::move(note));
  return {};
}

/// In the order of the units, whichever was read first. Two targets may compile one file.
std::vector<Note> PortPlanner::notes_on_left_out() const {
  std::vector<Note> notes;
  for (const auto& item : left_out_) {
    const Note& note = item.second;
    const auto says_it = [&](const Note& known) {
      return known.where->file == note.where->file && known.text == note.text;
    };
    if (std::none_of(notes.begin(), notes.end(), says_it)) notes.push_back(note);
  }
  return notes;
}

std::optional<Error> PortPlanner::collect() {
  readings_.resize(units_.size());
  CollectOptions options{
      options_.packages,
      generated_in_packages(options_),
      options_.others.headers_in_use ? *options_.others.headers_in_use : exported_dirs(options_.packages),
      &rules_,
      include_dirs(),
      trusted_,
      options_.dual};
  std::vector<std::size_t> all(units_.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  std::optional<Error> failure = read(all, options, "parsing");
  if (!failure) failure = read(add_debug_builds(), options, "parsing debug builds");
  if (!failure) failure = read(units_of_more_headers_in_use(options), options, "parsing again");
  if (failure) return failure;
  exported_ = options.exported_dirs;
  for (std::size_t i = 0; i < units_.size(); ++i) {
    if (!readings_[i].errors.empty()) continue;
    parsed_.push_back(units_[i]);
    reading_.merge(std::move(readings_[i]));
  }
  reading_.facts.leave_out_unshown_code();
  reading_.facts.refuse_unseen_functions();
  reading_.facts.refuse_unseen_friends();
  reading_.facts.add_overrides();
  leave_light_types(reading_.facts, options_.small);
  add_casts_elsewhere(reading_.facts, options_.others);
  return lacks_units();
}

/// Of units in which macros drop what they are given: what assert() is given must compile, and mean the same, after the port, too.
std::vector<std::size_t> PortPlanner::add_debug_builds() {
  std::vector<std::size_t> added;
  for (std::size_t i = 0, count = units_.size(); i < count; ++i) {
    if (readings_[i].preprocessor.dropped.empty()) continue;
    std::optional<CompileUnit> build = debug_build_of(units_[i]);
    if (!build) continue;
    debug_builds_.insert(build->id());
    added.push_back(units_.size());
    units_.push_back(std::move(*build));
  }
  readings_.resize(units_.size());
  return added;
}

/// What a header declares counts otherwise once others may include it: for the units that read it, which are read once more.
std::vector<std::size_t> PortPlanner::units_of_more_headers_in_use(CollectOptions& options) const {
  std::vector<std::size_t> again;
  if (!options_.others.more_headers_in_use) return again;
  UnitsOfFile units_of_file;
  for (const UnitReading& reading : readings_)
    for (const auto& [file, units] : reading.facts.units_of_file)
      units_of_file[file].insert(units.begin(), units.end());
  std::set<std::string> changed;
  for (const std::string& header : options_.others.more_headers_in_use(units_of_file)) {
    if (!options.exported_dirs.insert(header).second) continue;
    const std::set<std::string>& units = units_of_file[header];
    changed.insert(units.begin(), units.end());
  }
  for (std::size_t i = 0; i < units_.size(); ++i)
    if (readings_[i].errors.empty() && changed.count(units_[i].file) != 0) again.push_back(i);
  return again;
}

std::optional<Error> PortPlanner::read(const std::vector<std::size_t>& units, const CollectOptions& options,
                                       const std::string& stage) {
  std::optional<Error> failure;
  std::mutex mutex;
  // What is behind a failure need not be read: large packages take minutes. What is before it is read, so that the first
  // one is named whichever thread is the fastest.
  std::atomic<std::size_t> failed{std::numeric_limits<std::size_t>::max()};
  unsigned done = 0;
  in_parallel(options_.jobs, units.size(), [&](std::size_t i) {
    if (i > failed) return;
    const CompileUnit& unit = units_[units[i]];
    UnitReading& reading = readings_[units[i]];
    reading = read_unit(unit, options, options_.accesses);
    const std::lock_guard<std::mutex> lock(mutex);
    if (!reading.errors.empty() && i < failed) {
      if (std::optional<Error> error = sort_out(units[i])) {
        failure = std::move(error);
        failed = i;
      }
    }
    step(stage, ++done, units.size(), unit.file);
  });
  return failure;
}

std::optional<Error> PortPlanner::lacks_units() const {
  for (const auto& item : options_.build_dirs) {
    const std::string& package = item.first;
    const auto belongs = [&](const std::string& unit) { return owners_.at(unit) == package; };
    if (std::any_of(parsed_.begin(), parsed_.end(), [&](auto& unit) { return belongs(unit.file); })) continue;
    const auto first = std::find_if(left_out_.begin(), left_out_.end(),
                                    [&](const auto& item) { return belongs(item.second.where->file); });
    const Note& note = first->second;
    return Error{"no unit of the package compiles: " + note.text, note.where->file,
                 misses_header(note.text)
                     ? "Build the package first (generated headers must be there), then run again."
                     : "Repair the package until its own compiler accepts it, then run again."};
  }
  return {};
}

UnseenCode PortPlanner::unseen_code() const {
  const PreprocessorNotes& notes = reading_.preprocessor;
  UnseenCode code{
      compiled_by_none(notes.skipped, notes.compiled), {}, dropped_by_all(notes.dropped, notes.kept)};
  if (options_.others.unseen_files) code.files = options_.others.unseen_files(reading_.facts.units_of_file);
  return code;
}

PortPlans PortPlanner::finish(const Components& components, DemotionLoop::Result result) const {
  std::vector<Site> sites = describe_sites(reading_.facts, components, options_, result.solution);
  mark_pending(sites, reading_.facts, components, result.plan.edits);
  std::vector<Note> notes = notes_of(reading_, units_, options_);
  const std::vector<Note> left_out = notes_on_left_out();
  notes.insert(notes.end(), left_out.begin(), left_out.end());
  PlanSplitter splitter(options_.packages, owners_, reading_.facts.units_of_file);
  splitter.add(std::move(sites));
  splitter.add(std::move(notes));
  splitter.add(result.plan, result.contents);
  return splitter.plans();
}

Expected<void> PortPlanner::load() {
  for (const auto& [package, build_dir] : options_.build_dirs) {
    Expected<std::vector<CompileUnit>> units = load_units(package, build_dir);
    if (!units) return units.error();
    for (CompileUnit& unit : *units) {
      owners_.emplace(unit.file, package);
      units_.push_back(std::move(unit));
    }
  }
  Expected<TrustedFunctions> trusted = load_trusted_functions(options_.packages);
  if (!trusted) return trusted.error();
  trusted_ = std::move(*trusted);
  return {};
}

Expected<PortPlans> PortPlanner::run() {
  if (Expected<void> loaded = load(); !loaded) return loaded.error();
  if (std::optional<Error> failure = collect()) return *failure;
  const Components components(reading_.facts, options_.without_rules.count("all-or-nothing") == 0);
  ParseOptions parse_options;
  parse_options.include_dirs = include_dirs();
  parse_options.accesses = options_.accesses;
  Verifier verifier({parsed_, reading_.facts, reading_.calls, components, rules_, options_.packages},
                    parse_options, options_.jobs, read_file, options_.judges);
  const UnseenCode code = unseen_code();
  const UnseenUses unseen(code, reading_.facts, components, read_file);
  const OtherCodeLimits others(options_.others, exported_, unseen, reading_.preprocessor.texts);
  Expected<DemotionLoop::Result> result =
      DemotionLoop(reading_.facts, components, options_, others, verifier, read_file).run();
  if (!result) return result.error();
  PortPlans plans = finish(components, std::move(*result));
  if (options_.without_rules.count("completeness")) return plans;
  for (const auto& [package, plan] : plans)
    if (Expected<void> complete = check_complete(plan.report, reading_.api_calls); !complete)
      return complete.error();
  return plans;
}

}  // namespace

Expected<PortPlans> plan_ports(const EngineOptions& options) {
  return PortPlanner(options).run();
}

Expected<PortPlan> plan_port(const EngineOptions& options) {
  Expected<PortPlans> plans = plan_ports(options);
  if (!plans) return plans.error();
  return std::move(plans->begin()->second);
}

}  // namespace tzc::rewriter
