// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <ostream>
#include <set>

#include "emit/header.h"
#include "parse/identifier.h"
#include "parse/source.h"
#include "tool/commands.h"
#include "tool/inputs.h"
#include "tool/output.h"

namespace tzc::msggen {
namespace {

void check_usage(const GenerateOptions& options, Diagnostics& diagnostics) {
  if (options.installed) {
    if (!options.files.empty()) report_usage("--installed takes no files", "", diagnostics);
    return;
  }
  if (options.files.empty()) {
    report_usage("no files", "name .msg, .srv or .action files, or use --installed", diagnostics);
  }
  if (std::string fault = identifier_fault(options.package); !fault.empty()) {
    report_usage(fmt::format("the package's name '{}' {}", options.package, fault), "-p PACKAGE",
                 diagnostics);
  }
}

// The package's own messages are found beside the given files, too.
void add_own_folders(const GenerateOptions& options, SearchPath& path) {
  for (const std::string& file : options.files) {
    const std::string folder = std::filesystem::path(file).parent_path().string();
    auto& folders = path[options.package];
    const std::string named = folder.empty() ? "." : folder;
    if (std::find(folders.begin(), folders.end(), named) == folders.end()) folders.push_back(named);
  }
}

// What a file would hold that could not be read, or whose parts are not as they should be.
std::vector<std::string> names_expected_of(const std::string& file, const std::string& package) {
  const std::filesystem::path path = file;
  std::vector<std::string> suffixes = {""};
  if (path.extension() == ".srv") suffixes = {"", "Request", "Response"};
  if (path.extension() == ".action")
    suffixes = {"Action", "ActionGoal", "ActionResult", "ActionFeedback", "Goal", "Result", "Feedback"};
  std::vector<std::string> names;
  for (const std::string& suffix : suffixes) names.push_back(package + "/" + path.stem().string() + suffix);
  return names;
}

// One that does not exist, or holds something else, is no definition with faults.
bool is_definition(const std::string& file) {
  const std::string extension = std::filesystem::path(file).extension();
  return is_file(file) && (extension == ".msg" || extension == ".srv" || extension == ".action");
}

std::string reason(const Diagnostic& d) {
  const std::string file = std::filesystem::path(d.file).filename().string();
  return d.at.line ? fmt::format("{}:{}: {}", file, d.at.line, d.message) : d.message;
}

class Generator {
 public:
  explicit Generator(const GenerateOptions& options)
      : options_(options), library_(library_options(), diagnostics_) {}

  int run(Console console) {
    check_usage(options_, diagnostics_);
    if (!diagnostics_.empty()) {
      finish(diagnostics_, console);
      return exit_usage;
    }
    read();
    emit();
    const bool goes_on = keeps_going() && !has_strange_files_;
    if (!goes_on && !diagnostics_.empty()) return finish(diagnostics_, console);
    for (const Diagnostic& d : diagnostics_.sorted()) console.err << render(d, Severity::warning);
    Diagnostics failures;
    write(console, failures);
    return finish(failures, console);
  }

 private:
  bool keeps_going() const { return options_.keep_going || options_.installed; }

  LibraryOptions library_options() {
    SearchPath path = parse_includes(options_.includes, diagnostics_,
                                     keeps_going() ? MissingFolder::empty : MissingFolder::fault);
    if (!options_.installed) add_own_folders(options_, path);
    return {std::move(path), installed_packages, options_.installed};
  }

  void read() {
    for (const std::string& file : options_.files) add_file(file, options_.package);
    if (!options_.installed) return;
    const PackageIndex index = installed_packages();
    for (const auto& [name, package] : index.all()) {
      if (!package.installed) continue;  // a workspace's own packages generate their headers themselves
      for (const std::string& file : package.definition_files()) add_file(file, name);
    }
  }

  void add_file(const std::string& file, const std::string& package) {
    const std::size_t faults_before = diagnostics_.size();
    std::vector<std::string> names = library_.add_file(file, package);
    const bool has_faults = diagnostics_.size() > faults_before;
    if (!is_definition(file)) has_strange_files_ = true;
    if (names.empty() && has_faults) refuse(names_expected_of(file, package), diagnostics_[faults_before]);
    for (std::string& name : names) {
      if (has_faults) refusals_.emplace(name, reason(diagnostics_[faults_before]));
      names_.push_back(std::move(name));
    }
  }

  void refuse(const std::vector<std::string>& names, const Diagnostic& why) {
    for (const std::string& name : names) refused_.push_back(emit_refusal(name, reason(why)));
  }

  // The first header of a name counts: a package that only Python uses may have a message and a service of one name.
  void add(Header header) {
    if (paths_.insert(header.path).second) headers_.push_back(std::move(header));
  }

  void emit() {
    std::set<std::string> done;
    for (const std::string& name : names_) {
      if (done.insert(name).second) emit(name);
    }
    for (const auto& service : library_.services()) add(emit_service(service.package, service.name));
    for (Header& header : refused_) add(std::move(header));
  }

  void emit(const std::string& name) {
    const std::size_t faults_before = diagnostics_.size();
    if (const Message* message = library_.find(name)) {
      add(emit_message(*message, library_.analysis()));
      return;
    }
    std::string why = "a message in it has faults";
    if (diagnostics_.size() > faults_before) why = reason(diagnostics_[faults_before]);
    add(emit_refusal(name, refusals_.emplace(name, why).first->second));
  }

  void write(Console console, Diagnostics& failures) {
    const std::size_t replaced = write_headers(headers_, {options_.output, options_.if_changed}, failures);
    if (options_.installed && failures.empty() && replaced > 0) {
      console.out << fmt::format("tzc-msggen: {} of {} headers written to {}\n", replaced, headers_.size(),
                                 options_.output);
    }
  }

  const GenerateOptions& options_;
  Diagnostics diagnostics_;
  Library library_;
  std::vector<std::string> names_;
  std::map<std::string, std::string> refusals_;  // why a name has no twin
  std::vector<Header> headers_, refused_;
  std::set<std::string> paths_;  // of headers_
  bool has_strange_files_ = false;
};

}  // namespace

int generate(const GenerateOptions& options, Console console) {
  return Generator(options).run(console);
}

}  // namespace tzc::msggen
