// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

namespace tzc::msggen {

enum ExitStatus { exit_good = 0, exit_bad_input = 1, exit_usage = 2 };

/// Where a command writes: its result, and what is wrong.
struct Console {
  std::ostream& out;
  std::ostream& err;
};

struct GenerateOptions {
  std::string package;                ///< of the files
  std::vector<std::string> includes;  ///< "PKG:DIR"
  std::string output;
  std::vector<std::string> files;
  bool installed = false;  ///< instead of files: every message package of the machine; keeps going
  /// A definition with faults costs the others nothing: whoever includes its header is told.
  bool keep_going = false;
  bool if_changed = false;
};

struct ClassifyOptions {
  std::vector<std::string> inputs;    ///< folders and files
  std::vector<std::string> includes;  ///< "PKG:DIR"
  std::string package;                ///< of files that lie in no package's folder
  bool json = false;
};

struct ExplainOptions {
  std::vector<std::string> includes;  ///< "PKG:DIR"
  std::string type;                   ///< "PKG/Type"
};

int generate(const GenerateOptions& options, Console console);
int classify(const ClassifyOptions& options, Console console);
int explain(const ExplainOptions& options, Console console);

}  // namespace tzc::msggen
