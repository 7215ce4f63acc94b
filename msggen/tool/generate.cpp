// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <ostream>
#include <set>

#include "emit/header.h"
#include "parse/identifier.h"
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
    if (diagnostics_.empty()) write(console);
    return finish(diagnostics_, console);
  }

 private:
  LibraryOptions library_options() {
    SearchPath path = parse_includes(options_.includes, diagnostics_);
    if (!options_.installed) add_own_folders(options_, path);
    return {std::move(path), installed_packages, options_.installed};
  }

  void read() {
    for (const std::string& file : options_.files) add(library_.add_file(file, options_.package));
    if (!options_.installed) return;
    const PackageIndex index = installed_packages();
    for (const auto& [name, package] : index.all()) {
      if (!package.installed) continue;  // a workspace's own packages generate their headers themselves
      for (const std::string& file : package.definition_files()) add(library_.add_file(file, name));
    }
  }

  void add(const std::vector<std::string>& names) { names_.insert(names_.end(), names.begin(), names.end()); }

  void emit() {
    std::set<std::string> done;
    for (const std::string& name : names_) {
      if (!done.insert(name).second) continue;
      if (const Message* message = library_.find(name)) {
        headers_.push_back(emit_message(*message, library_.analysis()));
      }
    }
    for (const auto& service : library_.services())
      headers_.push_back(emit_service(service.package, service.name));
  }

  void write(Console console) {
    const std::size_t replaced =
        write_headers(headers_, {options_.output, options_.if_changed}, diagnostics_);
    if (options_.installed && diagnostics_.empty() && replaced > 0) {
      console.out << fmt::format("tzc-msggen: {} of {} headers written to {}\n", replaced, headers_.size(),
                                 options_.output);
    }
  }

  const GenerateOptions& options_;
  Diagnostics diagnostics_;
  Library library_;
  std::vector<std::string> names_;
  std::vector<Header> headers_;
};

}  // namespace

int generate(const GenerateOptions& options, Console console) {
  return Generator(options).run(console);
}

}  // namespace tzc::msggen
