// SPDX-License-Identifier: BSD-3-Clause
#include "tool/package_port.h"

#include <algorithm>
#include <filesystem>
#include <memory>
#include <set>

#include "buildfiles/compile_database.h"
#include "buildfiles/package_xml.h"
#include "buildfiles/plan.h"
#include "edits/apply.h"
#include "edits/dual.h"
#include "model/codes.h"
#include "proof/configuration.h"
#include "proof/own_compiler.h"
#include "tool/filter.h"
#include "tool/header_users.h"
#include "tool/invariant.h"
#include "tool/own_messages.h"
#include "tool/pending.h"
#include "tool/places.h"
#include "tool/suppressions.h"

namespace tzc::rewriter {
namespace fs = std::filesystem;
namespace {

/// The branch without TZC of a --dual package is not compiled, which is not worth a note.
bool is_about_dual_branch(const Note& note) {
  if (note.code != codes::TZC3002 || !note.where) return false;
  const Expected<std::string> content = read_file(note.where->file);
  return content && in_dual_branch(*content, note.where->line);
}

class Porter {
 public:
  Porter(const std::string& package_dir, const PortInputs& inputs) : inputs_(inputs) {
    port_.package_dir = package_dir;
  }

  Expected<PackagePort> run() {
    if (Expected<void> done = read_package(); !done) return done.error();
    if (!has_cpp()) return std::move(port_);
    for (const auto step :
         {&Porter::prepare, &Porter::plan_sources, &Porter::plan_build, &Porter::apply, &Porter::report})
      if (Expected<void> done = (this->*step)(); !done) return done.error();
    return std::move(port_);
  }

 private:
  Expected<void> read_package() {
    const Expected<PackageXml> package = read_package_xml(port_.package_dir);
    if (!package) return package.error();
    port_.result.report.package = package->name;
    port_.result.report.package_dir = port_.package_dir;
    port_.result.source_root = source_root(port_.package_dir);
    port_.before = snapshot(port_.package_dir);
    return {};
  }

  /// Metapackages, message packages and Python packages have nothing to port, and no compile commands either.
  bool has_cpp() const {
    static const std::set<std::string> extensions = {".cc", ".cpp", ".cxx", ".c++", ".C"};
    return std::any_of(port_.before.begin(), port_.before.end(), [](const auto& entry) {
      return extensions.count(std::filesystem::path(entry.first).extension()) != 0;
    });
  }

  Expected<void> prepare() {
    const Expected<std::string> build_dir = find_build_dir(
        port_.package_dir, port_.result.report.package, inputs_.options.build_dir, inputs_.options.packages);
    if (!build_dir) return build_dir.error();
    port_.build_dir = *build_dir;
    return {};
  }

  Expected<void> plan_sources() {
    const Expected<std::vector<std::string>> includes = find_tzc_includes(inputs_.options.tzc_includes);
    if (!includes) return includes.error();
    const Expected<OwnMessages> messages = OwnMessages::generate(port_.package_dir, port_.build_dir);
    if (!messages) return messages.error();
    EngineOptions engine = engine_options();
    engine.tzc_include = includes->front();
    engine.extra_include_dirs.assign(includes->begin() + 1, includes->end());
    for (const std::string& folder : messages->include_dirs()) engine.extra_include_dirs.push_back(folder);
    workspace_messages_ = messages->packages();
    OwnCompiler compiler(compiler_setup(engine));
    engine.judges = judges(compiler);
    if (inputs_.options.change_exported)
      engine.headers_in_use = find_headers_in_use(compiler_setup(engine).root);
    Expected<PortPlan> plan = inputs_.engine.plan(engine);
    if (!plan) return plan.error();
    plan_ = std::move(*plan);
    return {};
  }

  OwnCompilerSetup compiler_setup(const EngineOptions& engine) const {
    OwnCompilerSetup setup;
    setup.package_dir = port_.package_dir;
    const std::unique_ptr<UserBuild> user = UserBuild::find(port_.build_dir);
    setup.root = user ? user->source : fs::path(port_.package_dir).parent_path().string();
    setup.build_dir = port_.build_dir;
    setup.include_dirs = engine.extra_include_dirs;
    setup.include_dirs.push_back(engine.tzc_include);
    setup.defines = {dual_macro};
    setup.jobs = inputs_.options.jobs;
    setup.accesses = inputs_.accesses;
    return setup;
  }

  /// Exported headers that no other package is seen to include are the package's own.
  std::set<std::string> find_headers_in_use(const std::string& workspace) {
    const std::vector<std::string> roots = roots_of_users(
        port_.result.report.package, workspace, inputs_.options.packages, share_folders(port_.build_dir));
    const std::map<std::string, std::string> users = headers_in_use(port_.package_dir, roots);
    std::set<std::string> headers;
    for (const auto& item : users) headers.insert(item.first);
    port_.result.report.notes.push_back(note_on_users(port_.package_dir, users));
    return headers;
  }

  /// Verify the text that is written.
  Expected<std::string> written_text(const std::string& file, const std::string& before,
                                     const std::string& edited) const {
    std::string after = edited;
    if (inputs_.engine.format) after = inputs_.engine.format(file, before, after);
    return inputs_.options.dual ? dual_text(file, before, after) : Expected<std::string>(after);
  }

  Judges judges(OwnCompiler& compiler) const {
    Judges judges;
    judges.written_text = [this](const std::string& file, const std::string& before,
                                 const std::string& edited) { return written_text(file, before, edited); };
    judges.compiler = [&compiler](const FileContents& contents, const std::set<std::string>& units) {
      return compiler.check(contents, units);
    };
    judges.original_errors = [&compiler](const std::string& unit) {
      return compiler.errors_of_original(unit);
    };
    return judges;
  }

  EngineOptions engine_options() const {
    const Options& options = inputs_.options;
    EngineOptions engine;
    engine.package_dir = port_.package_dir;
    engine.build_dir = port_.build_dir;
    engine.max_level = options.level;
    engine.on_exhausted = options.on_exhausted;
    engine.small = options.small;
    engine.mem_size = options.mem_size;
    engine.measured_sizes = inputs_.measured_sizes;
    engine.dual = options.dual;
    engine.jobs = options.jobs;
    engine.strict = options.strict;
    engine.wanted = make_filter(options.only, options.except, port_.package_dir);
    engine.progress = inputs_.progress;
    engine.accesses = inputs_.accesses;
    return engine;
  }

  Expected<void> plan_build() {
    BuildNeeds needs;
    needs.package_dir = port_.package_dir;
    needs.build_dir = port_.build_dir;
    needs.main_files = plan_.ported_targets_files;
    for (const Edit& edit : plan_.edits) needs.edited_files.insert(edit.file);
    needs.tzc_types = plan_.tzc_types;
    needs.twinless = twinless();
    needs.dual = inputs_.options.dual;
    Expected<BuildPlan> build = plan_build_files(needs);
    if (!build) return build.error();
    plan_.edits.insert(plan_.edits.end(), build->edits.begin(), build->edits.end());
    port_.hints = build->notes;
    for (const std::string& unit : plan_.ported_targets_files) {
      const std::vector<std::string> sources =
          unity_sources(unit);  // another build tree has another unity file
      port_.units.insert(sources.begin(), sources.end());
      if (sources.empty()) port_.units.insert(unit);
    }
    return {};
  }

  /// Other message packages of the workspace whose twins the ported code needs and that do not make them.
  std::set<std::string> twinless() const {
    std::set<std::string> packages;
    for (const std::string& type : plan_.tzc_types) {
      const std::string package = type.substr(0, type.find('/'));
      const auto found = workspace_messages_.find(package);
      if (found != workspace_messages_.end() && found->second != port_.package_dir &&
          !makes_own_twins(found->second))
        packages.insert(package);
    }
    return packages;
  }

  Expected<void> apply() {
    for (const auto& [file, edits] : by_file(plan_.edits)) {
      if (!is_below(file, port_.package_dir))
        return Error{"an edit of the rule '" + edits.front().rule + "' lies outside the package", file,
                     "this is a defect of tzc-rewrite, please report it; nothing was written"};
      if (Expected<void> done = apply_to(file, edits); !done) return done;
    }
    return {};
  }

  Expected<void> apply_to(const std::string& file, const Edits& edits) {
    const Expected<std::string> before = read_file(file);
    if (!before) return before.error();
    const auto analysed = port_.before.find(file);
    if (analysed == port_.before.end() || analysed->second != content_hash(*before))
      return Error{"changed while the package was being analysed; nothing was written", file,
                   "run tzc-rewrite again"};
    const auto verified = plan_.contents.find(file);
    const Expected<std::string> after =
        verified == plan_.contents.end() ? apply_edits(*before, edits) : verified->second;
    if (!after) return after.error();
    if (*after == *before) return {};
    port_.contents[file] = *after;
    port_.result.changes.push_back({file.substr(port_.package_dir.size() + 1), *before, *after});
    return {};
  }

  Expected<void> report() {
    Report& report = port_.result.report;
    report.sites = std::move(plan_.report.sites);
    for (const Note& note : plan_.report.notes)
      if (!is_about_dual_branch(note)) report.notes.push_back(note);
    std::set<std::string> files;
    for (const std::string& file : plan_.parsed_files)
      if (is_below(file, port_.package_dir)) files.insert(file);
    apply_suppressions(report, files);
    port_.result.pending = pending_places(port_.result);
    return check_report(report);
  }

  const PortInputs& inputs_;
  std::map<std::string, std::string> workspace_messages_;
  PortPlan plan_;
  PackagePort port_;
};

}  // namespace

Expected<PackagePort> port_package(const std::string& package_dir, const PortInputs& inputs) {
  return Porter(package_dir, inputs).run();
}

}  // namespace tzc::rewriter
