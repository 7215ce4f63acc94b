// SPDX-License-Identifier: BSD-3-Clause
#include "tool/run.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <iterator>
#include <map>
#include <optional>
#include <system_error>

#include "buildfiles/find_packages.h"
#include "other_code/header_users.h"
#include "port/filter.h"
#include "port/port_cache.h"
#include "port/port_writer.h"
#include "port/prove.h"
#include "remarks/baseline.h"
#include "tool/bag.h"
#include "tool/printing.h"
#include "tool/report_files.h"
#include "tool/terminal.h"
#include "transaction/swap.h"
#include "workspace/git.h"

namespace tzc::rewriter {
namespace {

class Run {
 public:
  Run(const Options& options, const Engine& engine)
      : options_(options), engine_(engine), progress_(!options.quiet) {}

  int run() {
    for (const auto step : {&Run::read_inputs, &Run::open_outputs, &Run::recover_packages})
      if (Expected<void> done = (this->*step)(); !done) return report_error(done.error()), status();
    for (const std::vector<std::string>& packages : groups()) port_group(packages);
    progress_.end();
    warn_about_filters();
    if (failed_ && ports_.empty()) return status();
    for (const std::string& warning : writer_->warnings()) say("tzc-rewrite: warning: " + warning + "\n");
    if (Expected<void> done = print(); !done) report_error(done.error());
    if (Expected<void> done = write_reports(); !done) report_error(done.error());
    return status();
  }

 private:
  void report_error(const Error& error) {
    failed_ = true;
    progress_.clear();
    const bool colour = wants_colour(STDERR_FILENO);
    say(fmt::format("tzc-rewrite: {}error:{} {}\n", colour ? "\033[1;31m" : "", colour ? "\033[0m" : "",
                    to_string(error)));
  }

  Expected<void> read_inputs() {
    for (const std::string& argument : options_.packages) {
      const Expected<std::vector<std::string>> found = find_packages_at(argument);
      if (!found) return found.error();
      for (const std::string& package : *found)
        if (std::find(packages_.begin(), packages_.end(), package) == packages_.end())
          packages_.push_back(package);
    }
    std::error_code ignored;
    if (!options_.build_dir.empty() && !std::filesystem::exists(options_.build_dir, ignored))
      return Error{"is no folder", options_.build_dir, "name the folder of compile_commands.json after -p"};
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

  /// Finds out what cannot be written before the analysis, which may take minutes.
  Expected<void> open_outputs() {
    Expected<ReportFiles> reports = ReportFiles::open(options_.reports);
    if (!reports) return reports.error();
    reports_.emplace(std::move(*reports));
    Expected<PortWriter> writer = PortWriter::open(options_, packages_);
    if (!writer) return writer.error();
    writer_.emplace(std::move(*writer));
    return {};
  }

  Expected<void> recover_packages() {
    for (const std::string& folder : swap_folders(packages_, ::geteuid())) {
      const Expected<std::vector<std::string>> replaced = recover(folder);
      if (!replaced) return replaced.error();
      finished_another_run_ = finished_another_run_ || !replaced->empty();
      if (!replaced->empty())
        say(fmt::format("tzc-rewrite: {}: finished a run that had been interrupted ({} files)\n", folder,
                        replaced->size()));
    }
    return {};
  }

  /// Packages of one build tree are proved together and written together; those of others are kept apart, so
  /// that what is done stays when something later fails. Where headers may change with all who include them, all are
  /// together.
  std::vector<std::vector<std::string>> groups() const {
    if (options_.change_exported) return {packages_};
    std::map<std::string, std::size_t> known;
    std::vector<std::vector<std::string>> all;
    for (const std::string& package : packages_) {
      const std::string tree = build_tree_of(package, options_);
      const auto group = known.emplace(tree, all.size());
      if (group.second) all.emplace_back();
      all[group.first->second].push_back(package);
    }
    return all;
  }

  /// What the file system refuses where nobody asked it before ends this group alone: others may be written by now.
  void port_group(const std::vector<std::string>& packages) {
    try {
      port_and_write(packages);
    } catch (const std::system_error& error) {
      report_error({error.what(), packages.front(), ""});
    }
  }

  void port_and_write(const std::vector<std::string>& packages) {
    PortInputs inputs{options_, engine_, measured_, graphs_, &progress_};
    PortCache cache(packages, inputs);
    std::optional<std::vector<PackagePort>> known = cache.find();
    std::vector<PackagePort> ports = known ? std::move(*known) : analysed(packages, inputs, cache);
    Expected<void> done = writer_->write(ports);
    if (!done) report_error(done.error());
    std::move(ports.begin(), ports.end(), std::back_inserter(ports_));
  }

  /// Packages that cannot be analysed are left out, with an error.
  std::vector<PackagePort> analysed(const std::vector<std::string>& packages, PortInputs inputs,
                                    PortCache& cache) {
    inputs.accesses = cache.record();
    std::vector<PackagePort> ports;
    for (const std::vector<std::string>& set : sets_of(packages)) analyse(set, inputs, ports);
    const Expected<void> done = prove_build_files(ports, inputs);
    if (!done) return report_error(done.error()), std::vector<PackagePort>();
    if (ports.size() == packages.size()) cache.keep(ports);
    return ports;
  }

  /// Packages that are solved as one.
  std::vector<std::vector<std::string>> sets_of(const std::vector<std::string>& packages) const {
    if (options_.change_exported) return joined_by_headers(packages);
    std::vector<std::vector<std::string>> sets;
    for (const std::string& package : packages) sets.push_back({package});
    return sets;
  }

  /// What cannot be solved as one is solved alone, and then the headers that others include stay.
  void analyse(const std::vector<std::string>& set, const PortInputs& inputs,
               std::vector<PackagePort>& ports) {
    Expected<std::vector<PackagePort>> found = port_packages(set, inputs);
    if (found) {
      say_results(*found);
      std::move(found->begin(), found->end(), std::back_inserter(ports));
    } else if (set.size() == 1) {
      report_error(found.error());
    } else {
      progress_.clear();
      say(fmt::format(
          "tzc-rewrite: warning: packages that include headers of each other are ported one by one, and "
          "these headers stay, because they could not be solved as one: {}\n",
          to_string(found.error())));
      for (const std::string& package : set) analyse({package}, inputs, ports);
    }
  }

  /// Reports come when all is done, which may be in an hour, or never when the run is interrupted.
  void say_results(const std::vector<PackagePort>& ports) {
    if (packages_.size() == 1) return;
    for (const PackagePort& port : ports)
      progress_.say(port.result.report.package + ": " + in_one_line(port.result.report));
  }

  /// Packages that could not be analysed may have sites that match.
  void warn_about_filters() {
    if (ports_.size() < packages_.size()) return;
    for (const std::string& filter : options_.only) {
      const bool matches = std::any_of(ports_.begin(), ports_.end(), [&](const PackagePort& port) {
        const SiteFilter wanted = make_filter({filter}, {}, port.package_dir);
        const std::vector<Site>& sites = port.result.report.sites;
        return std::any_of(sites.begin(), sites.end(), wanted);
      });
      if (matches) continue;
      // A check that looks at nothing would pass.
      const bool is_error = options_.action == Action::check;
      say(fmt::format("tzc-rewrite: {}: --only {} matches no site\n", is_error ? "error" : "warning",
                      filter));
      failed_ |= is_error;
    }
  }

  /// The packages may be written by now, so that it fails is no reason to leave out the files with reports.
  Expected<void> print() const {
    std::error_code failed;
    try {
      print_reports(options_, ports_, {status(), writer_->undo_command()});
      if (std::fflush(stdout) != 0) failed.assign(errno, std::generic_category());
    } catch (const std::system_error& error) {  // what fmt could not write
      failed = error.code();
    }
    if (!failed) return {};
    return Error{"cannot be written: " + failed.message(), "standard output",
                 "--quiet prints nothing, --report FILE keeps the report"};
  }

  Expected<void> write_reports() {
    if (options_.reports.empty()) return {};
    RunReport all;
    for (const PackagePort& port : ports_) {
      all.push_back(port.result);
      all.back().message_sizes = measured_;
      all.back().commit = commit_of(port.package_dir);
      all.back().written = options_.action == Action::apply || options_.action == Action::out_dir;
    }
    return reports_->write(all, {TZC_VERSION, utc_now(), options_.command});
  }

  /// Status 2 means that nothing was written, so a failure after a write ends with 1.
  Status status() const {
    const bool wrote = finished_another_run_ || (writer_ && writer_->has_written());
    if (failed_) return wrote ? work_left : failed;
    if (options_.action == Action::apply || options_.action == Action::out_dir)
      return std::any_of(ports_.begin(), ports_.end(), [](auto& port) { return port.refused; })
                 ? work_left
                 : nothing_left;
    return std::any_of(ports_.begin(), ports_.end(), [&](auto& port) { return has_work(port); })
               ? work_left
               : nothing_left;
  }

  bool has_work(const PackagePort& port) const {
    const Report& report = port.result.report;
    const bool edits = !port.contents.empty();
    if (!baseline_) return edits || has_refusal(port);
    return std::any_of(report.sites.begin(), report.sites.end(), [&](const Site& site) {
      const bool open = is_refusal(site) || (edits && site.pending && !site.suppressed);
      return open && !baseline_->accepts(report, site);
    });
  }

  static std::string utc_now() {
    const std::time_t now = std::time(nullptr);
    std::tm utc{};
    gmtime_r(&now, &utc);
    char text[32];
    return {text, std::strftime(text, sizeof text, "%Y-%m-%d %H:%M UTC", &utc)};
  }

  const Options& options_;
  const Engine& engine_;
  TerminalProgress progress_;
  std::vector<std::string> packages_;
  std::map<std::string, std::uint64_t> measured_;
  IncludeGraphs graphs_;
  std::optional<Baseline> baseline_;
  std::optional<ReportFiles> reports_;
  std::optional<PortWriter> writer_;
  std::vector<PackagePort> ports_;
  bool failed_ = false, finished_another_run_ = false;
};

}  // namespace

int run(const Options& options, const Engine& engine) {
  return Run(options, engine).run();
}

int tool_main(int argc, const char* const* argv, const Engine& engine) {
  ::signal(SIGPIPE, SIG_IGN);  // a pipe whose reader is gone ends no run that writes files: printing fails
  const auto parsed = parse_options(argc, argv);
  if (const auto* options = std::get_if<Options>(&parsed)) return run(*options, engine);
  const Answer& answer = std::get<Answer>(parsed);
  fmt::print(answer.status == 0 ? stdout : stderr, "{}", answer.text);
  return answer.status;
}

}  // namespace tzc::rewriter
