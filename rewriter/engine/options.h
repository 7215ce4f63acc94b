// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "engine/port_plan.h"
#include "model/copied_definition.h"
#include "model/file_accesses.h"
#include "model/judges.h"
#include "model/location.h"
#include "model/progress.h"
#include "model/solve_options.h"
#include "model/unseen_file.h"

namespace tzc::rewriter {

/// What is known of code that is not analysed.
struct OtherCode {
  /// Headers of the packages that other code includes, whose declarations stay; none: all in exported folders.
  std::optional<std::set<std::string>> headers_in_use;
  /// Names more of them, once it is known which units read which file. May be empty.
  std::function<std::set<std::string>(const UnitsOfFile&)> more_headers_in_use;
  std::vector<CopiedDefinition> copied;  ///< definitions that stay
  FindUnseenFiles unseen_files;          ///< may be empty
  /// Where another package, which may be given messages of a type ("sensor_msgs/Image"), may cast their const away. May be empty.
  std::function<std::optional<Location>(const std::string&)> cast_elsewhere;
  /// Message packages whose twins are generated in the build folder of who uses them, where other packages do not see them.
  std::set<std::string> unshared_twins;
};

struct EngineOptions : SolveOptions {
  /// Package -> the folder of its compile_commands.json; a package that has nothing but headers is not among them.
  std::map<std::string, std::string> build_dirs;
  bool dual = false;                            ///< output that still builds without TZC
  unsigned jobs = 0;                            ///< 0: one per processor
  std::string tzc_include;                      ///< TZC's own headers and the twins of installed messages
  std::vector<std::string> extra_include_dirs;  ///< generated twins of the package's own messages
  /// Rules that are not applied, so that a test can show that each is needed; also "verification",
  /// "all-or-nothing", "completeness".
  std::set<std::string> without_rules;
  bool strict = false;  ///< a unit that does not parse is an error, whatever the package's compiler says
  Judges judges;
  Progress* progress = nullptr;
  FileAccesses* accesses = nullptr;  ///< told what the parses read; may be null
  OtherCode others;
};

}  // namespace tzc::rewriter
