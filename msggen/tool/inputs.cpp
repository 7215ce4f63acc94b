// SPDX-License-Identifier: BSD-3-Clause
#include "tool/inputs.h"

#include <fmt/format.h>

#include <filesystem>
#include <ostream>

namespace tzc::msggen {

SearchPath parse_includes(const std::vector<std::string>& includes, Diagnostics& diagnostics,
                          MissingFolder missing) {
  SearchPath path;
  for (const std::string& include : includes) {
    const std::size_t colon = include.find(':');
    if (colon == std::string::npos || colon == 0 || colon + 1 == include.size()) {
      report_usage(fmt::format("-I {}: a package and a folder are expected", include), "write -I PKG:DIR",
                   diagnostics);
      continue;
    }
    const std::string folder = include.substr(colon + 1);
    std::error_code ignored;
    if (!std::filesystem::is_directory(folder, ignored)) {
      if (missing == MissingFolder::fault)
        report_usage(fmt::format("-I {}: no such folder", include),
                     "name the folder that holds the package's .msg files", diagnostics);
      continue;
    }
    path[include.substr(0, colon)].push_back(folder);
  }
  return path;
}

PackageIndex installed_packages() {
  return PackageIndex(ros_package_path());
}

void report_usage(std::string message, std::string hint, Diagnostics& diagnostics) {
  Diagnostic d;
  d.message = std::move(message);
  d.hint = std::move(hint);
  diagnostics.report(std::move(d));
}

int finish(const Diagnostics& diagnostics, Console console) {
  for (const Diagnostic& d : diagnostics.sorted()) console.err << render(d);
  return diagnostics.empty() ? exit_good : exit_bad_input;
}

}  // namespace tzc::msggen
