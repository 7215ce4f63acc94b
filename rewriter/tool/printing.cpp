// SPDX-License-Identifier: BSD-3-Clause
#include "tool/printing.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

#include "model/codes.h"
#include "port/writing.h"
#include "tool/next_steps.h"
#include "tool/terminal.h"

namespace tzc::rewriter {
namespace {

std::vector<BuiltPackage> changed_packages(const std::vector<PackagePort>& ports) {
  std::vector<BuiltPackage> packages;
  for (const PackagePort& port : ports)
    if (!port.contents.empty()) packages.push_back({port.package_dir, port.build_dir});
  return packages;
}

/// What a package's own compiler refuses was not looked at; most often the package was not built, and lacks headers.
std::string unread(const std::vector<PackagePort>& ports) {
  std::size_t files = 0;
  for (const PackagePort& port : ports)
    for (const Note& note : port.result.report.notes) files += note.code == codes::TZC3003;
  if (files == 0) return "";
  return fmt::format(" in what was read; {} not (TZC3003): build the packages first, then run again",
                     files == 1 ? "1 file was" : fmt::format("{} files were", files));
}

std::string closing_line(const Options& options, const std::vector<PackagePort>& ports,
                         const Outcome& outcome) {
  const std::vector<BuiltPackage> changed = changed_packages(ports);
  const bool open = std::any_of(ports.begin(), ports.end(), has_refusal);
  if (changed.empty() && open) return "no change; some sites stay on TCPROS\n";
  if (changed.empty() && outcome.status == Status::failed)
    return "nothing to port in what was analysed; the errors say what was not\n";
  if (changed.empty()) return "nothing to port" + unread(ports) + "\n";
  switch (options.action) {
    case Action::apply:
      return next_steps(changed) +
             (outcome.undo.empty() ? "" : "the port is taken back by\n  " + outcome.undo + "\n");
    case Action::out_dir:
      return "ported copies are in " + options.out_dir + "\n";
    case Action::check:
      return outcome.status != 0 ? "not ported yet; tzc-rewrite --apply does it\n" : "nothing new to port\n";
    case Action::diff:
      return "nothing was written; --apply does it\n";
  }
  return "";
}

}  // namespace

bool has_refusal(const PackagePort& port) {
  const std::vector<Site>& sites = port.result.report.sites;
  return std::any_of(sites.begin(), sites.end(), is_refusal);
}

void print_reports(const Options& options, const std::vector<PackagePort>& ports, const Outcome& outcome) {
  const bool is_diff = options.action == Action::diff;
  TextStyle style;
  style.colour = wants_colour(is_diff ? STDERR_FILENO : STDOUT_FILENO);
  std::string text;
  if (!options.quiet) {
    for (const PackagePort& port : ports) text += to_text(port.result, style) + "\n";
    text += closing_line(options, ports, outcome);
  }
  if (is_diff)
    say(text), fmt::print("{}", diff_of(ports));
  else
    fmt::print("{}", text);
}

}  // namespace tzc::rewriter
