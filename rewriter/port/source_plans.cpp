// SPDX-License-Identifier: BSD-3-Clause
#include "port/source_plans.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <memory>
#include <set>

#include "buildfiles/compile_database.h"
#include "buildfiles/plan.h"
#include "edits/dual.h"
#include "edits/files.h"
#include "model/erase_if.h"
#include "other_code/copied_definitions.h"
#include "other_code/header_users.h"
#include "other_code/workspace_code.h"
#include "port/filter.h"
#include "proof/configuration.h"
#include "proof/own_compiler.h"
#include "workspace/own_messages.h"
#include "workspace/places.h"

namespace tzc::rewriter {
namespace fs = std::filesystem;
namespace {

using HeaderUsers = std::map<std::string, std::string>;

/// Whether the compiler sees it wherever it reads the file: otherwise the header's change could break code that was
/// not looked at.
bool is_compiled(const Inclusion& inclusion, const UnitsOfFile& units_of_file) {
  const auto users = units_of_file.find(inclusion.file), seen = units_of_file.find(inclusion.header);
  return users != units_of_file.end() && seen != units_of_file.end() &&
         std::includes(seen->second.begin(), seen->second.end(), users->second.begin(), users->second.end());
}

/// -include FILE: precompiled headers.
std::vector<std::string> included_by_option(const CompileCommand& command) {
  std::vector<std::string> files;
  for (std::size_t i = 0; i + 1 < command.arguments.size(); ++i)
    if (command.arguments[i] == "-include")
      files.push_back(canonical_path((fs::path(command.directory) / command.arguments[i + 1]).string()));
  return files;
}

std::set<std::string> keys_of(const std::map<std::string, std::string>& map) {
  std::set<std::string> keys;
  for (const auto& item : map) keys.insert(item.first);
  return keys;
}

class SourcePlanner {
 public:
  SourcePlanner(const std::vector<SourcePackage>& packages, const PortInputs& inputs)
      : packages_(packages), inputs_(inputs) {
    for (const SourcePackage& package : packages_) build_dirs_[package.dir] = package.build_dir;
    own_ = FolderSet(folders());
  }

  Expected<SourcePlans> run() {
    const Expected<std::vector<std::string>> includes = find_tzc_includes(inputs_.options.tzc_includes);
    if (!includes) return includes.error();
    const Expected<OwnMessages> messages = OwnMessages::generate(build_dirs_);
    if (!messages) return messages.error();
    EngineOptions engine = engine_options();
    engine.tzc_include = includes->front();
    engine.extra_include_dirs.assign(includes->begin() + 1, includes->end());
    for (const std::string& folder : messages->include_dirs()) engine.extra_include_dirs.push_back(folder);
    OwnCompiler compiler(compiler_setup(engine));
    engine.judges = judges(compiler);
    engine.others.copied = copies();
    engine.others.unshared_twins = unshared_twins(*messages);
    const WorkspaceCode workspace_code(
        packages_, [this](const std::string& file) { return is_dead(file); }, inputs_.graphs,
        inputs_.accesses);
    engine.others.unseen_files = [&](const UnitsOfFile& units_of_file) {
      return living(unseen_files(workspace_code.includes(), engine.packages, units_of_file));
    };
    engine.others.cast_elsewhere = [&](const std::string& type) {
      return workspace_code.cast_elsewhere(type);
    };
    Expected<PortPlans> plans =
        inputs_.options.change_exported ? plan_with_headers(engine) : plan_without_headers(engine);
    if (!plans) return plans.error();
    SourcePlans result{std::move(*plans), messages->packages(), {}};
    for (const auto& [folder, plan] : result.plans)
      result.users.emplace(folder, workspace_code.users_of(plan.contents));
    return result;
  }

 private:
  bool is_dead(const std::string& file) const { return is_file_of(file, inputs_.options.dead_files, own_); }
  std::vector<UnseenFile> living(std::vector<UnseenFile> files) const {
    erase_if(files, [this](const UnseenFile& unseen) { return is_dead(unseen.file); });
    return files;
  }

  std::vector<std::string> folders() const {
    std::vector<std::string> folders;
    for (const auto& item : build_dirs_) folders.push_back(item.first);
    return folders;
  }

  /// The deepest folder that holds all packages, as the build names it.
  std::string workspace() const {
    std::vector<std::string> sources;
    for (const auto& [folder, build_dir] : build_dirs_) {
      const std::unique_ptr<UserBuild> user = UserBuild::find(build_dir);
      sources.push_back(user ? user->root() : fs::path(folder).parent_path().string());
    }
    return common_folder(sources);
  }

  OwnCompilerSetup compiler_setup(const EngineOptions& engine) const {
    OwnCompilerSetup setup;
    setup.packages = folders();
    setup.root = workspace();
    std::set<std::string> build_dirs;
    for (const auto& item : engine.build_dirs) build_dirs.insert(item.second);
    setup.build_dirs.assign(build_dirs.begin(), build_dirs.end());
    setup.include_dirs = engine.extra_include_dirs;
    setup.include_dirs.push_back(engine.tzc_include);
    setup.defines = {dual_macro};
    setup.jobs = inputs_.options.jobs;
    setup.accesses = inputs_.accesses;
    setup.progress = [this](unsigned done, unsigned total, const std::string& unit) {
      if (inputs_.progress) inputs_.progress->step("compiling", done, total, unit);
    };
    return setup;
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
    const PortOptions& options = inputs_.options;
    EngineOptions engine;
    engine.packages = own_;
    for (const SourcePackage& package : packages_)
      if (package.has_units) engine.build_dirs[package.dir] = package.build_dir;
    engine.max_level = options.level;
    engine.on_exhausted = options.on_exhausted;
    engine.small = options.small;
    engine.mem_size = options.mem_size;
    engine.measured_sizes = inputs_.measured_sizes;
    engine.dual = options.dual;
    engine.jobs = options.jobs;
    engine.strict = options.strict;
    engine.wanted = make_filter(options.only, options.except, engine.packages);
    engine.progress = inputs_.progress;
    engine.accesses = inputs_.accesses;
    return engine;
  }

  /// What the packages' compiler is told to read.
  std::set<std::string> compiled() const {
    std::set<std::string> files;
    for (const auto& [package, build_dir] : build_dirs_)
      if (const Expected<std::vector<CompileCommand>> commands = read_compile_commands(build_dir))
        for (const CompileCommand& command : *commands) {
          std::vector<std::string> sources = unity_sources(command.file);
          if (sources.empty()) sources.push_back(command.canonical);
          const auto is_own = [&](const std::string& source) { return is_below(source, package); };
          if (std::none_of(sources.begin(), sources.end(), is_own)) continue;
          files.insert(sources.begin(), sources.end());
          for (const std::string& file : included_by_option(command)) files.insert(file);
        }
    return files;
  }

  /// Exported headers that no other code is seen to include are the packages' own. What one of the packages includes of
  /// another without that a compiler sees it is known once the units are parsed. Most of it is known before that, and then no
  /// unit has to be parsed again.
  Expected<PortPlans> plan_with_headers(EngineOptions& engine) const {
    std::vector<Inclusion> between = inclusions_between(folders());
    erase_if(between, [&](const Inclusion& inclusion) { return is_dead(inclusion.file); });
    const std::set<std::string> reached = reached_by_includes(folders(), compiled());
    std::vector<Inclusion> unseen = between;
    erase_if(unseen, [&](const Inclusion& inclusion) { return reached.count(inclusion.file) != 0; });
    HeaderUsers users = headers_in_use(engine.packages, searched(), unseen);
    engine.others.headers_in_use = keys_of(users);
    engine.others.more_headers_in_use = [&](const UnitsOfFile& units_of_file) {
      const std::size_t known = unseen.size();
      for (const Inclusion& inclusion : between)
        if (users.count(inclusion.header) == 0 && !is_compiled(inclusion, units_of_file))
          unseen.push_back(inclusion);
      if (unseen.size() != known) users = headers_in_use(engine.packages, searched(), unseen);
      return keys_of(users);
    };
    Expected<PortPlans> plans = inputs_.engine.plan(engine);
    if (plans) add_notes(users, *plans);
    return plans;
  }

  Expected<PortPlans> plan_without_headers(const EngineOptions& engine) const {
    Expected<PortPlans> plans = inputs_.engine.plan(engine);
    if (!plans) return plans;
    for (auto& [folder, plan] : *plans)
      if (std::optional<Note> note = note_on_kept_headers(plan.report)) plan.report.notes.push_back(*note);
    return plans;
  }

  /// Packages of the workspace whose messages have no TZC headers but those that their users generate for themselves.
  std::set<std::string> unshared_twins(const OwnMessages& messages) const {
    std::set<std::string> names;
    for (const auto& [name, folder] : messages.packages())
      if (!(packages_.size() == 1 && build_dirs_.count(folder) != 0) && !makes_own_twins(folder))
        names.insert(name);
    return names;
  }

  std::vector<CopiedDefinition> copies() const {
    std::vector<CopiedDefinition> all;
    for (const std::string& space : source_spaces(packages_))
      for (CopiedDefinition& copied : copied_definitions(own_, space)) all.push_back(std::move(copied));
    return all;
  }

  SearchedFolders searched() const {
    std::set<std::string> names, shares;
    for (const SourcePackage& package : packages_) {
      names.insert(package.name);
      for (const std::string& folder : share_folders(package.build_dir)) shares.insert(folder);
    }
    SearchedFolders all = folders_of_users(names, workspace(), inputs_.options.packages, shares);
    for (const SourcePackage& package : packages_) all.roots.push_back(source_space(package.dir));
    return all;
  }

  void add_notes(const HeaderUsers& users, PortPlans& plans) const {
    for (auto& [folder, plan] : plans) {
      std::vector<std::string> others;
      for (const SourcePackage& package : packages_)
        if (package.dir != folder) others.push_back(package.name);
      plan.report.notes.push_back(note_on_users(folder, users, others));
    }
  }

  const std::vector<SourcePackage>& packages_;
  const PortInputs& inputs_;
  std::map<std::string, std::string> build_dirs_;
  FolderSet own_;  ///< the packages that are ported
};

}  // namespace

Expected<SourcePlans> plan_sources(const std::vector<SourcePackage>& packages, const PortInputs& inputs) {
  return SourcePlanner(packages, inputs).run();
}

}  // namespace tzc::rewriter
