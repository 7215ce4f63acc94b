// SPDX-License-Identifier: BSD-3-Clause
#include "proof/raised_units.h"

#include <algorithm>
#include <set>
#include <string>
#include <utility>

#include "edits/files.h"
#include "edits/in_parallel.h"
#include "edits/standard_flags.h"
#include "proof/own_compiler.h"
#include "proof/unit_needs.h"

namespace tzc::rewriter {
namespace {

/// A file and the target that compiles it: another target may keep its standard.
using Unit = std::pair<std::string, std::string>;

std::set<Unit> units_from_cxx11_on(const CommandsOfTree& commands) {
  std::set<Unit> units;
  for (const CompileCommand& command : commands.ported)
    if (!is_before_cxx11(standard_of(command)))
      units.emplace(canonical_path(commands.to_user.in_word(command.file)), command.target);
  return units;
}

/// Units that the port changes, or that include what it changes, are compiled with the port.
std::vector<const CompileCommand*> raised_commands(const PortedPackage& package,
                                                   const CommandsOfTree& commands) {
  const std::set<Unit> raised = units_from_cxx11_on(commands);
  std::vector<const CompileCommand*> found;
  for (const CompileCommand& command : commands.before)
    if (is_before_cxx11(standard_of(command)) && is_below(command.canonical, package.package_dir) &&
        package.units.count(command.canonical) == 0 && raised.count({command.canonical, command.target}) != 0)
      found.push_back(&command);
  return found;
}

}  // namespace

std::optional<Error> rejected_as_cxx14(const PortedPackage& package, const CommandsOfTree& commands,
                                       const ProofOptions& options) {
  const std::vector<const CompileCommand*> raised = raised_commands(package, commands);
  if (raised.empty()) return {};
  if (options.accesses) options.accesses->give_up();  // what the compiler reads is not noted here
  if (options.progress) options.progress("compiling as C++14 what was older");
  std::vector<std::vector<CompilerError>> errors(raised.size());
  in_parallel(options.jobs, raised.size(), [&](std::size_t i) { errors[i] = errors_of_cxx14(*raised[i]); });
  const auto rejected =
      std::find_if(errors.begin(), errors.end(), [](const auto& of_unit) { return !of_unit.empty(); });
  if (rejected == errors.end()) return {};
  const CompilerError& first = rejected->front();
  return Error{"the edited build files ask for C++14, as which the package's compiler rejects this file: " +
                   first.text,
               first.unit, "repair the file, which the port does not touch, and run tzc-rewrite again"};
}

}  // namespace tzc::rewriter
