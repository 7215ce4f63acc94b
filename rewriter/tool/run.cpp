// SPDX-License-Identifier: BSD-3-Clause
#include "tool/run.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "edits/swap.h"
#include "tool/bag.h"
#include "tool/baseline.h"
#include "tool/places.h"
#include "tool/terminal.h"
#include "tool/writing.h"

namespace tzc::rewriter {
namespace {

enum Status { nothing_left = 0, work_left = 1, failed = 2 };

class Run {
 public:
  Run(const Options& options, const Engine& engine)
      : options_(options), engine_(engine), progress_(!options.quiet) {}

  int run() {
    for (const auto step : {&Run::read_inputs, &Run::recover_packages, &Run::plan, &Run::write_out})
      if (Expected<void> done = (this->*step)(); !done) return report_error(done.error());
    print_reports();
    if (Expected<void> done = write_reports(); !done) return report_error(done.error());
    return status();
  }

 private:
  int report_error(const Error& error) {
    progress_.clear();
    const bool colour = wants_colour(STDERR_FILENO);
    fmt::print(stderr, "tzc-rewrite: {}error:{} {}\n", colour ? "\033[1;31m" : "", colour ? "\033[0m" : "",
               to_string(error));
    return failed;
  }

  Expected<void> read_inputs() {
    for (const std::string& argument : options_.packages) {
      const Expected<std::vector<std::string>> found = find_packages_at(argument);
      if (!found) return found.error();
      for (const std::string& package : *found)
        if (std::find(packages_.begin(), packages_.end(), package) == packages_.end())
          packages_.push_back(package);
    }
    for (const std::string& bag : options_.bags) {
      const auto sizes = measure_bag(bag);
      if (!sizes) return sizes.error();
      for (const auto& [topic, size] : by_source_name(*sizes))
        measured_[topic] = std::max(measured_[topic], size);
    }
    if (options_.baseline.empty()) return {};
    Expected<Baseline> baseline = Baseline::read(options_.baseline);
    if (!baseline) return baseline.error();
    baseline_ = std::move(*baseline);
    return {};
  }

  Expected<void> recover_packages() {
    for (const std::string& package : packages_) {
      const Expected<std::vector<std::string>> replaced = recover(package);
      if (!replaced) return replaced.error();
      if (!replaced->empty())
        fmt::print(stderr, "tzc-rewrite: {}: finished a run that had been interrupted ({} files)\n", package,
                   replaced->size());
    }
    return {};
  }

  Expected<void> plan() {
    const PortInputs inputs{options_, engine_, measured_, &progress_};
    for (const std::string& package : packages_) {
      Expected<PackagePort> port = port_package(package, inputs);
      if (!port) return port.error();
      ports_.push_back(std::move(*port));
    }
    progress_.clear();
    return {};
  }

  Expected<void> write_out() {
    switch (options_.action) {
      case Action::apply:
        if (!options_.force)
          if (Expected<void> committed = check_committed(ports_); !committed) return committed;
        return write_in_place(ports_);
      case Action::out_dir:
        return write_copies(ports_, options_.out_dir);
      case Action::diff:
      case Action::check:
        return {};
    }
    return {};
  }

  /// The report goes to standard output unless the diff does.
  void print_reports() const {
    const bool is_diff = options_.action == Action::diff;
    std::FILE* stream = is_diff ? stderr : stdout;
    TextStyle style;
    style.colour = wants_colour(is_diff ? STDERR_FILENO : STDOUT_FILENO);
    if (!options_.quiet) {
      for (const PackagePort& port : ports_) fmt::print(stream, "{}\n", to_text(port.result, style));
      fmt::print(stream, "{}", closing_line());
      std::fflush(stream);
    }
    if (is_diff) fmt::print("{}", diff_of(ports_));
  }

  std::string closing_line() const {
    const auto changed =
        std::count_if(ports_.begin(), ports_.end(), [](auto& port) { return !port.contents.empty(); });
    const bool open = std::any_of(ports_.begin(), ports_.end(), has_refusal);
    if (changed == 0) return open ? "no change; some sites stay on TCPROS\n" : "nothing to port\n";
    switch (options_.action) {
      case Action::apply:
        return "ported; build the workspace again\n";
      case Action::out_dir:
        return "ported copies are in " + options_.out_dir + "\n";
      case Action::check:
        return status() == work_left ? "not ported yet; tzc-rewrite --apply does it\n"
                                     : "nothing new to port\n";
      case Action::diff:
        return "nothing was written; --apply does it\n";
    }
    return "";
  }

  Expected<void> write_reports() const {
    RunReport all;
    for (const PackagePort& port : ports_) all.push_back(port.result);
    for (const std::string& file : options_.reports) {
      const std::string extension = std::filesystem::path(file).extension();
      const std::string text = extension == ".json"    ? to_json(all)
                               : extension == ".sarif" ? to_sarif(all, TZC_VERSION)
                                                       : to_html(all);
      if (Expected<void> done = write_file(file, text); !done) return done;
    }
    return {};
  }

  int status() const {
    if (options_.action == Action::apply || options_.action == Action::out_dir) return nothing_left;
    return std::any_of(ports_.begin(), ports_.end(), [&](auto& port) { return has_work(port); })
               ? work_left
               : nothing_left;
  }

  static bool has_refusal(const PackagePort& port) {
    const std::vector<Site>& sites = port.result.report.sites;
    return std::any_of(sites.begin(), sites.end(), is_refusal);
  }

  bool has_work(const PackagePort& port) const {
    const Report& report = port.result.report;
    const bool edits = !port.contents.empty();
    if (!baseline_) return edits || has_refusal(port);
    return std::any_of(report.sites.begin(), report.sites.end(), [&](const Site& site) {
      const bool open = is_refusal(site) || (edits && site.level != Level::not_needed && !site.suppressed);
      return open && !baseline_->accepts(report, site);
    });
  }

  const Options& options_;
  const Engine& engine_;
  TerminalProgress progress_;
  std::vector<std::string> packages_;
  std::map<std::string, std::uint64_t> measured_;
  std::optional<Baseline> baseline_;
  std::vector<PackagePort> ports_;
};

}  // namespace

int run(const Options& options, const Engine& engine) {
  return Run(options, engine).run();
}

int tool_main(int argc, const char* const* argv, const Engine& engine) {
  const auto parsed = parse_options(argc, argv);
  if (const auto* options = std::get_if<Options>(&parsed)) return run(*options, engine);
  const Answer& answer = std::get<Answer>(parsed);
  fmt::print(answer.status == 0 ? stdout : stderr, "{}", answer.text);
  return answer.status;
}

}  // namespace tzc::rewriter
