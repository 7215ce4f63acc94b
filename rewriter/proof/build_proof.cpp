// SPDX-License-Identifier: BSD-3-Clause
#include "proof/build_proof.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "edits/files.h"
#include "proof/cmake_reads.h"
#include "proof/generated_headers.h"
#include "proof/raised_units.h"
#include "proof/unit_needs.h"

namespace tzc::rewriter {
namespace {

using Failures = std::map<std::string, Error>;

class Prover {
 public:
  Prover(const UserBuild& user, const std::vector<PortedPackage>& packages, const ProofOptions& options)
      : user_(user), options_(options) {
    for (const PortedPackage& package : packages) left_.push_back(&package);
  }

  Failures run() {
    while (!left_.empty()) {
      Configuration configuration(user_, folders(left_), options_.prefixes);
      step("configuring a scratch copy");
      const Expected<void> done = configuration.configure(contents(left_));
      if (done) {
        check(configuration);
        break;
      }
      if (options_.accesses) options_.accesses->give_up();  // what CMake read up to an error is not known
      if (!find_culprits(configuration, done.error())) break;
    }
    return std::move(failures_);
  }

 private:
  using Packages = std::vector<const PortedPackage*>;

  void step(const std::string& stage) const {
    if (options_.progress) options_.progress(stage);
  }

  static std::vector<std::string> folders(const Packages& packages) {
    std::vector<std::string> all;
    for (const PortedPackage* package : packages) all.push_back(package->package_dir);
    return all;
  }

  static FileContents contents(const Packages& packages) {
    FileContents all;
    for (const PortedPackage* package : packages)
      all.insert(package->contents.begin(), package->contents.end());
    return all;
  }

  void fail(const PortedPackage& package, Error error) {
    failures_.emplace(package.package_dir, std::move(error));
    left_.erase(std::remove(left_.begin(), left_.end(), &package), left_.end());
  }

  /// When the workspace cannot be configured with all packages: leaves out those that fail alone, those that CMake names first. To
  /// try each takes as long as to configure the workspace for each. False: there is nothing more to try.
  bool find_culprits(const Configuration& configuration, const Error& together) {
    const Packages all = left_;
    if (const std::optional<Error> original = error_without_port(all)) return fail_all(all, *original), false;
    if (all.size() == 1 || !configuration.is_prepared()) return fail_all(all, together), false;
    Packages suspects = all;
    const auto is_first = [&](const PortedPackage* package) {
      return is_named(*package, configuration.sources(), together);
    };
    const auto rest = std::stable_partition(suspects.begin(), suspects.end(), is_first);
    for (auto at = suspects.begin(); at != suspects.end(); ++at) {
      if (at == rest && left_.size() < all.size()) break;
      try_alone(**at);
    }
    if (left_.size() < all.size()) return true;
    return fail_all(all, together), false;
  }

  void fail_all(const Packages& packages, const Error& error) {
    for (const PortedPackage* package : packages) fail(*package, error);
  }

  /// CMake names files below the workspace by their path in it.
  static bool is_named(const PortedPackage& package, const ScratchWorkspace& copy, const Error& error) {
    const std::string& folder = copy.scratch(package.package_dir);
    const std::string inside = is_below(folder, copy.folder()) ? folder.substr(copy.folder().size() + 1) : "";
    const auto names = [&](const std::string& path) {
      return error.what.find(" at " + path + "/") != std::string::npos;
    };
    return names(package.package_dir) || (!inside.empty() && names(inside));
  }

  void try_alone(const PortedPackage& package) {
    Configuration alone(user_, {package.package_dir}, options_.prefixes);
    step("configuring a scratch copy of " + package.name);
    if (const Expected<void> done = alone.configure(package.contents); !done) fail(package, done.error());
  }

  /// The error that the workspace has also without the port; looked for once.
  std::optional<Error> error_without_port(const Packages& packages) {
    if (std::exchange(knows_original_, true)) return {};
    Configuration original(user_, folders(packages), options_.prefixes);
    step("configuring a scratch copy without the port");
    const Expected<void> done = original.configure({});
    if (done) return {};
    Error error = done.error();
    error.what = "a scratch copy of the workspace cannot be configured, even without the port: " + error.what;
    return error;
  }

  void check(const Configuration& configuration) {
    Expected<std::vector<CompileCommand>> commands = read_compile_commands(configuration.build_dir());
    const std::vector<CmakeTarget> targets = read_cmake_targets(configuration.build_dir());
    if (options_.accesses)
      note_cmake_reads(configuration.build_dir(), configuration.sources().to_user(), *options_.accesses);
    const Expected<std::vector<CompileCommand>> originals = read_compile_commands(user_.build_dir);
    const Packages all = left_;
    for (const PortedPackage* package : all) {
      std::optional<Error> error;
      if (!commands && !package->units.empty()) error = commands.error();
      if (commands && !package->units.empty())
        error = first_lack(*package, *commands, targets, configuration.sources());
      if (!error && commands && originals)
        error =
            rejected_as_cxx14(*package, {*originals, *commands, configuration.sources().to_user()}, options_);
      if (error) fail(*package, *error);
    }
    if (options_.build && !left_.empty()) build(configuration);
  }

  static std::set<std::string> sources_of(const CompileCommand& command, const ScratchWorkspace& copy) {
    std::set<std::string> files = {canonical_path(copy.to_user().in_word(command.file))};
    for (const std::string& source : unity_sources(command.file))
      files.insert(copy.to_user().in_word(source));
    return files;
  }

  static std::optional<Error> first_lack(const PortedPackage& package,
                                         const std::vector<CompileCommand>& commands,
                                         const std::vector<CmakeTarget>& targets,
                                         const ScratchWorkspace& copy) {
    std::set<std::string> unseen = package.units;
    const PathMap& to_user = copy.to_user();
    const GeneratedHeaders generated(targets, package.contents, package.made, to_user);
    for (const CompileCommand& command : commands)
      for (const std::string& file : sources_of(command, copy)) {
        if (!package.units.count(file) && !package.users.count(file)) continue;
        unseen.erase(file);
        const bool ported = package.units.count(file) != 0;
        auto lack = lack_of(command, targets);
        if (!lack && ported) lack = generated.lack(command, file);
        if (lack && ported) return about(command, file, *lack);
        if (lack && includes_any(command, package.contents, to_user))
          return about(command, file, as_user(*lack));
      }
    if (unseen.empty()) return {};
    return Error{"no target of the configured copy compiles it", *unseen.begin(), ""};
  }

  static Lack as_user(const Lack& lack) {
    return {"it includes a header that the port changes, and " + lack.what, lack.hint};
  }

  static std::optional<Lack> lack_of(const CompileCommand& command, const std::vector<CmakeTarget>& targets) {
    if (const auto lack = lacks_for_tzc(command)) return lack;
    const CmakeTarget* target = linked_without_tzc(targets, command.target);
    if (!target) return {};
    return Lack{"the target " + target->name + " does not link TZC's libraries", ""};
  }

  static Error about(const CompileCommand& command, const std::string& file, const Lack& lack) {
    const std::string target = command.target.empty() ? "" : " for the target " + command.target;
    return {"configured with the edited build files" + target + ", " + lack.what, file, lack.hint};
  }

  void build(const Configuration& configuration) {
    step("building the scratch copy");
    const Expected<void> done = configuration.build(options_.jobs);
    if (done) return;
    const Packages all = left_;
    for (const PortedPackage* package : all) fail(*package, done.error());
  }

  const UserBuild& user_;
  const ProofOptions& options_;
  Packages left_;
  Failures failures_;
  bool knows_original_ = false;
};

}  // namespace

namespace {

std::optional<Lack> lack_of_user(const CompileCommand& command, const GetsTzc& gets_tzc) {
  if (std::optional<Lack> standard = lacks_standard(command)) return standard;
  std::optional<Lack> folder = lacks_for_tzc(command);
  if (!folder || gets_tzc(command)) return {};
  folder->hint =
      "add tzc to the package.xml and the catkin components of the package that is built there, build it, "
      "and run "
      "tzc-rewrite again";
  return folder;
}

}  // namespace

std::optional<Error> outdated_user(const PortedPackage& package, const std::vector<CompileCommand>& users,
                                   const GetsTzc& gets_tzc) {
  for (const CompileCommand& command : users) {
    const std::optional<Lack> lack = lack_of_user(command, gets_tzc);
    if (!lack || !includes_any(command, package.contents, {})) continue;
    const char* what = package.contents.count(command.canonical) != 0
                           ? "compiles this file, which the port changes, in "
                           : "includes a header that the port changes, in ";
    return Error{"another package " + (what + command.directory) + ", and " + lack->what, command.canonical,
                 lack->hint};
  }
  return {};
}

Failures unproved_packages(const UserBuild& user, const std::vector<PortedPackage>& packages,
                           const ProofOptions& options) {
  return Prover(user, packages, options).run();
}

}  // namespace tzc::rewriter
