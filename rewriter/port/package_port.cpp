// SPDX-License-Identifier: BSD-3-Clause
#include "port/package_port.h"

#include <algorithm>
#include <iterator>
#include <set>

#include "buildfiles/build_trees.h"
#include "buildfiles/cmake_project.h"
#include "buildfiles/compile_database.h"
#include "buildfiles/package_xml.h"
#include "buildfiles/plan.h"
#include "buildfiles/unread_files.h"
#include "edits/apply.h"
#include "edits/dual.h"
#include "model/codes.h"
#include "port/source_plans.h"
#include "remarks/invariant.h"
#include "remarks/pending.h"
#include "remarks/suppressions.h"
#include "workspace/build_folder.h"
#include "workspace/git.h"
#include "workspace/own_messages.h"

namespace tzc::rewriter {
namespace {

/// The branch without TZC of a --dual package is not compiled, which is not worth a note.
bool is_about_dual_branch(const Note& note) {
  if (note.code != codes::TZC3002 || !note.where) return false;
  const Expected<std::string> content = read_file(note.where->file);
  return content && in_dual_branch(*content, note.where->line);
}

void append(std::vector<Note>& notes, const std::vector<Note>& more) {
  notes.insert(notes.end(), more.begin(), more.end());
}

/// Notes on its sources when no unit is read.
std::vector<Note> sources_of(const PackagePort& port) {
  return unread_sources(port.package_dir, generated_folders(port.build_dir, port.package_dir), {});
}

/// Of a package of which nothing is read the headers are not either.
void note_headers(PackagePort& port) {
  append(port.result.report.notes,
         unread_headers(port.package_dir, generated_folders(port.build_dir, port.package_dir), {}));
}

/// What a package without sources compiles of others'. One that makes no target has no need of a compile database, which may be large.
void note_sources_elsewhere(PackagePort& port, const PackagePlace& place, const PortInputs& inputs) {
  const Expected<CmakeProject> project = load_cmake_project(port.package_dir);
  const auto makes_target = [](const CmakeListFile& file) {
    return std::any_of(file.commands.begin(), file.commands.end(), [](const CmakeCommand& command) {
      return command.name.find("add_executable") != std::string::npos ||
             command.name.find("add_library") != std::string::npos;
    });
  };
  if (!project || std::none_of(project->files.begin(), project->files.end(), makes_target)) return;
  const std::string build_dir = find_configured_dir(place, inputs.options.build_dir, inputs.options.packages);
  if (build_dir.empty()) return;
  if (inputs.accesses) inputs.accesses->note(build_dir + "/compile_commands.json");
  append(port.result.report.notes,
         unread_compiled(port.package_dir, build_dir, generated_folders(build_dir, port.package_dir), {}));
}

/// Where its compile commands are; none: it compiles nothing. Its sources may be tests that are not configured.
Expected<void> find_build(PackagePort& port, const PackagePlace& place, const PortInputs& inputs) {
  const PortOptions& options = inputs.options;
  const std::vector<Note> sources = sources_of(port);
  if (sources.empty()) return note_sources_elsewhere(port, place, inputs), Expected<void>();
  const Expected<std::string> build_dir = find_build_dir(place, options.build_dir, options.packages);
  if (build_dir) {
    port.build_dir = *build_dir;
    port.has_units = true;
    return {};
  }
  const std::string configured = find_configured_dir(place, options.build_dir, options.packages);
  if (configured.empty()) return build_dir.error();
  if (Expected<void> exports = check_exports(configured, place); !exports) return exports.error();
  append(port.result.report.notes, sources);
  return {};
}

/// `others`: whether packages are solved together with it.
Expected<PackagePort> read_package(const std::string& package_dir, bool others, const PortInputs& inputs) {
  const Expected<PackageXml> package = read_package_xml(package_dir);
  if (!package) return package.error();
  PackagePort port;
  port.package_dir = package_dir;
  port.result.report.package = package->name;
  port.result.report.package_dir = package_dir;
  port.result.source_root = source_root(package_dir);
  port.before = snapshot(package_dir);
  const PackagePlace place{package_dir, package->name};
  if (Expected<void> done = find_build(port, place, inputs); !done) return done.error();
  if (!port.has_units && others)
    port.build_dir = find_configured_dir(place, inputs.options.build_dir, inputs.options.packages);
  return port;
}

/// Applies what was planned for a package's sources, and plans its build files.
class Porter {
 public:
  Porter(PackagePort& port, PortPlan plan, const std::map<std::string, std::string>& workspace_messages,
         bool dual)
      : port_(port), plan_(std::move(plan)), workspace_messages_(workspace_messages), dual_(dual) {}

  Expected<void> run() {
    port_.joined = plan_.joined;
    port_.before = of_read_files(std::move(port_.before), read_files());
    for (const auto step : {&Porter::plan_build, &Porter::apply, &Porter::report})
      if (Expected<void> done = (this->*step)(); !done) return done.error();
    return {};
  }

 private:
  Expected<void> plan_build() {
    BuildNeeds needs;
    needs.package_dir = port_.package_dir;
    needs.build_dir = port_.build_dir;
    needs.main_files = plan_.ported_targets_files;
    for (const Edit& edit : plan_.edits) needs.edited_files.insert(edit.file);
    needs.tzc_types = plan_.tzc_types;
    needs.twinless = twinless();
    port_.made = made_headers();
    needs.dual = dual_;
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

  /// Whatever they are called: sources may include a file of any name, so may CMakeLists.txt, and package.xml may be a link.
  std::set<std::string> read_files() const {
    std::set<std::string> files = {canonical_path(port_.package_dir + "/package.xml")};
    for (const auto& item : plan_.units_of_file) files.insert(item.first);
    if (const Expected<CmakeProject> project = load_cmake_project(port_.package_dir))
      for (const CmakeListFile& file : project->files) files.insert(file.path);
    return files;
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

  std::map<std::string, std::string> made_headers() const {
    std::map<std::string, std::string> headers;
    for (const std::string& type : plan_.tzc_types)
      if (const auto found = workspace_messages_.find(type.substr(0, type.find('/')));
          found != workspace_messages_.end())
        headers["tzc/" + type + ".h"] = found->second;
    return headers;
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
    if (analysed == port_.before.end())
      return Error{
          "is new, hidden or no text of up to 4 MB, and such files are not changed; nothing was written",
          file, "leave its sites out with --except, or give the file another place or name"};
    if (analysed->second != content_hash(*before))
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
    for (const auto& item : plan_.units_of_file) files.insert(item.first);
    apply_suppressions(report, files);
    port_.result.pending = pending_places(port_.result);
    return check_report(report);
  }

  PackagePort& port_;
  PortPlan plan_;
  const std::map<std::string, std::string>& workspace_messages_;
  const bool dual_;
};

std::vector<PackagePort> all_of(std::vector<PackagePort> ports, std::vector<PackagePort> others) {
  std::move(others.begin(), others.end(), std::back_inserter(ports));
  return ports;
}

}  // namespace

Expected<std::vector<PackagePort>> port_packages(const std::vector<std::string>& package_dirs,
                                                 const PortInputs& inputs) {
  std::vector<PackagePort> idle, ports;
  for (const std::string& package_dir : package_dirs) {
    Expected<PackagePort> port = read_package(package_dir, package_dirs.size() > 1, inputs);
    if (!port) return port.error();
    (port->build_dir.empty() ? idle : ports).push_back(std::move(*port));
  }
  std::for_each(idle.begin(), idle.end(), note_headers);
  if (std::none_of(ports.begin(), ports.end(), [](auto& port) { return port.has_units; })) {
    std::for_each(ports.begin(), ports.end(), note_headers);
    return all_of(std::move(ports), std::move(idle));
  }
  std::vector<SourcePackage> packages;
  for (const PackagePort& port : ports)
    packages.push_back({port.package_dir, port.result.report.package, port.build_dir, port.has_units});
  Expected<SourcePlans> sources = plan_sources(packages, inputs);
  if (!sources) return sources.error();
  for (PackagePort& port : ports) {
    Porter porter(port, std::move(sources->plans.at(port.package_dir)), sources->workspace_messages,
                  inputs.options.dual);
    if (Expected<void> done = porter.run(); !done) return done.error();
    port.users = std::move(sources->users[port.package_dir]);
  }
  return all_of(std::move(ports), std::move(idle));
}

}  // namespace tzc::rewriter
