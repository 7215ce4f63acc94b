// SPDX-License-Identifier: BSD-3-Clause
#include "port/prove.h"

#include <map>
#include <memory>
#include <optional>
#include <utility>

#include "buildfiles/package_xml.h"
#include "edits/files.h"
#include "model/codes.h"
#include "proof/build_proof.h"
#include "workspace/build_folder.h"
#include "workspace/places.h"
#include "workspace/tzc_by_catkin.h"

namespace tzc::rewriter {
namespace {

/// Packages that one build tree builds.
struct Group {
  std::unique_ptr<UserBuild> user;
  std::vector<PackagePort*> ports;
};

std::map<std::string, Group> groups_of(std::vector<PackagePort>& ports) {
  std::map<std::string, Group> groups;
  for (PackagePort& port : ports) {
    if (port.contents.empty() && port.joined.empty()) continue;
    std::unique_ptr<UserBuild> user = UserBuild::find(port.build_dir);
    Group& group = groups[user ? user->build_dir : port.build_dir];
    if (!group.user) group.user = std::move(user);
    group.ports.push_back(&port);
  }
  return groups;
}

/// `sources`: of the build tree. What the messages of others become is there already, or comes with their next build.
PortedPackage as_ported(const PackagePort& port, const std::string& sources) {
  PortedPackage package{
      port.result.report.package, port.package_dir, port.contents, port.units, port.users.sources, {}};
  const std::string root = canonical_path(sources);
  for (const auto& [header, folder] : port.made)
    if (folder == root || is_below(folder, root)) package.made.insert(header);
  return package;
}

void note(PackagePort& port, const char* code, const std::string& file, const std::string& text) {
  port.result.report.notes.push_back({code, Location{file, 1, 1}, text});
}

/// A hint for the user: the edit that was left to the user, otherwise a run without a proof.
std::string advice(const std::vector<Note>& hints) {
  std::string text;
  for (const Note& hint : hints) text += (text.empty() ? "" : "; ") + hint.text;
  return text.empty() ? "make TZC known to the target there by hand and run tzc-rewrite again" : text;
}

bool was_left_out(const Site& site) {
  return site.level == Level::plain && (site.code == codes::TZC1015 || site.code == codes::TZC2007);
}

class Refuser {
 public:
  explicit Refuser(const PortInputs& inputs) : inputs_(inputs) {}

  /// The package as it is reported when nothing of it is changed.
  Expected<void> refuse(PackagePort& port, const Error& why) {
    PortOptions options = inputs_.options;
    options.level = Level::plain;
    const PortInputs unported{options,        inputs_.engine,   inputs_.measured_sizes,
                              inputs_.graphs, inputs_.progress, inputs_.accesses};
    Expected<std::vector<PackagePort>> unchanged = port_packages({port.package_dir}, unported);
    if (!unchanged) return unchanged.error();
    const std::vector<Note> hints = port.hints;
    port = std::move(unchanged->front());
    port.contents.clear();
    port.result.changes.clear();
    port.result.pending.clear();
    port.refused = true;
    for (Site& site : port.result.report.sites)
      if (was_left_out(site)) {
        site.code = codes::TZC4005;
        site.reason = "nothing of the package is changed: " + why.what;
        site.flow_path.clear();
      }
    note(port, codes::TZC4005, why.where.empty() ? port.package_dir + "/CMakeLists.txt" : why.where,
         why.what + "; nothing of the package is changed; " + (why.hint.empty() ? advice(hints) : why.hint));
    return {};
  }

 private:
  const PortInputs& inputs_;
};

Error nothing_to_configure(const std::string& build_dir) {
  return {"its build folder has no CMakeCache.txt, so the edited build files cannot be configured", build_dir,
          "name the folder that CMake configured with -p, or port with --verify=source and check the build "
          "yourself"};
}

/// By the package's folder.
using Failures = std::map<std::string, Error>;

Failures failures_of(const Group& group, const PortInputs& inputs) {
  Failures failures;
  if (!group.user) {
    for (const PackagePort* port : group.ports)
      failures.emplace(port->package_dir, nothing_to_configure(port->build_dir));
    return failures;
  }
  std::vector<PortedPackage> packages;
  for (const PackagePort* port : group.ports) packages.push_back(as_ported(*port, group.user->source));
  ProofOptions options;
  options.prefixes = find_tzc_prefixes(inputs.options.tzc_includes);
  options.build = inputs.options.verify == Verify::build;
  options.jobs = inputs.options.jobs;
  options.accesses = inputs.accesses;
  options.progress = [&](const std::string& stage) {
    if (inputs.progress) inputs.progress->step(stage, 0, 1, group.user->source);
  };
  failures = unproved_packages(*group.user, packages, options);
  for (std::size_t i = 0; i < packages.size(); ++i) {
    TzcByCatkin exported(packages[i]);
    // Others do not define the macro of --dual: for them nothing changes.
    const auto gets_tzc = [&](const CompileCommand& command) {
      return inputs.options.dual || exported.reaches(command);
    };
    if (std::optional<Error> why = outdated_user(packages[i], group.ports[i]->users.commands, gets_tzc))
      failures.emplace(packages[i].package_dir, std::move(*why));
  }
  return failures;
}

/// What is right only together with a package that is not changed is not changed either.
Failures with_joined(const Failures& failures, const std::vector<PackagePort>& ports) {
  Failures all = failures;
  for (const PackagePort& port : ports)
    for (const std::string& other : port.joined)
      if (const auto failed = failures.find(other); failed != failures.end())
        all.emplace(port.package_dir,
                    Error{"it is ported as one with " + other + ", which cannot be: " + failed->second.what,
                          failed->second.where, failed->second.hint});
  return all;
}

}  // namespace

Expected<void> prove_build_files(std::vector<PackagePort>& ports, const PortInputs& inputs) {
  if (inputs.options.verify == Verify::source) {
    for (PackagePort& port : ports) {
      auto& notes = port.result.report.notes;
      notes.insert(notes.end(), port.hints.begin(), port.hints.end());
      if (!port.contents.empty())
        note(port, codes::TZC4006, port.package_dir + "/CMakeLists.txt",
             "the edited build files were not configured (--verify=source): build the package to know that "
             "they are right");
    }
    return {};
  }
  Failures failures;
  for (const auto& item : groups_of(ports)) failures.merge(failures_of(item.second, inputs));
  failures = with_joined(failures, ports);
  for (PackagePort& port : ports)
    if (const auto failed = failures.find(port.package_dir); failed != failures.end())
      if (Expected<void> done = Refuser(inputs).refuse(port, failed->second); !done) return done;
  return {};
}

std::string build_tree_of(const std::string& package_dir, const PortOptions& options) {
  const Expected<PackageXml> package = read_package_xml(package_dir);
  const Expected<std::string> build_dir =
      find_build_dir({package_dir, package ? package->name : ""}, options.build_dir, options.packages);
  if (!build_dir) return package_dir;
  const CmakeCache cache = CmakeCache::nearest(*build_dir);
  return cache.empty() ? *build_dir : cache.folder();
}

}  // namespace tzc::rewriter
