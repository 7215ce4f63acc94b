// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <ostream>
#include <set>

#include "parse/folders.h"
#include "parse/source.h"
#include "tool/commands.h"
#include "tool/inputs.h"

namespace tzc::msggen {
namespace {

namespace fs = std::filesystem;

struct Totals {
  std::size_t types = 0, has_variable_array = 0, has_data_part = 0;
  std::size_t without_data_part() const { return has_variable_array - has_data_part; }
};

// The input of a census: definition files, each with its package.
struct Input {
  std::string file, package;
};

bool holds_definitions(const fs::path& folder) {
  const std::string name = folder.filename().string();
  return name == "msg" || name == "srv" || name == "action";
}

// That of the next folder above that has a package.xml, or is above a msg/, srv/ or action/; else the folder
// that the file is in.
Package package_of_file(const std::string& file) {
  const fs::path own_folder = fs::absolute(file).lexically_normal().parent_path();
  for (fs::path folder = own_folder; folder != folder.parent_path(); folder = folder.parent_path()) {
    const fs::path above = holds_definitions(folder) ? folder.parent_path() : folder;
    if (above == folder && !is_file(folder / "package.xml")) continue;
    if (auto package = package_in(above.string())) return *package;
  }
  return {own_folder.filename().string(), own_folder.string()};
}

class Census {
 public:
  explicit Census(const ClassifyOptions& options) : options_(options) {}

  int run(Console console) {
    SearchPath path = parse_includes(options_.includes, usage_);
    for (const std::string& input : options_.inputs) collect(input, path);
    if (inputs_.empty()) report_empty_folders();
    if (!usage_.empty()) {
      finish(usage_, console);
      return exit_usage;
    }
    Library library({std::move(path), installed_packages, true}, diagnostics_);
    std::set<std::string> names;
    for (const Input& input : inputs_) {
      const auto found = library.add_file(input.file, input.package);
      names.insert(found.begin(), found.end());
    }
    for (const std::string& name : names) count(name, library);
    options_.json ? print_json(console.out) : print_text(console.out);
    for (const Diagnostic& d : diagnostics_.sorted()) console.err << render(d);
    return exit_good;  // what cannot be resolved is part of the answer
  }

 private:
  void collect(const std::string& input, SearchPath& path) {
    std::error_code ignored;
    if (fs::is_directory(input, ignored)) return collect_folder(input, path);
    if (!fs::is_regular_file(input, ignored))
      return report_usage(input + ": no such file or folder", "", usage_);
    const Package package = package_of_file(input);
    const std::string name = options_.package.empty() ? package.name : options_.package;
    inputs_.push_back({input, name});
    const fs::path folder = fs::absolute(input).lexically_normal().parent_path();
    add_to_path(folder.string(), path[name]);
    if (!options_.package.empty()) return;
    for (const std::string& inner : package.message_directories()) {
      if (is_folder(inner)) add_to_path(inner, path[name]);
    }
  }

  static void add_to_path(const std::string& folder, std::vector<std::string>& folders) {
    if (std::find(folders.begin(), folders.end(), folder) == folders.end()) folders.push_back(folder);
  }

  void collect_folder(const std::string& folder, SearchPath& path) {
    const PackageIndex index({folder});
    const std::size_t before = inputs_.size();
    for (const auto& [name, package] : index.all()) {
      for (const std::string& file : package.definition_files()) inputs_.push_back({file, name});
      for (const std::string& folder : package.message_directories()) path[name].push_back(folder);
    }
    if (inputs_.size() == before) collect_loose_files(folder, path);
  }

  // A plain folder of definitions, msg/ itself for example.
  void collect_loose_files(const std::string& folder, SearchPath& path) {
    std::set<std::string> files;
    for (const auto& entry : fs::directory_iterator(folder)) {
      const std::string extension = entry.path().extension().string();
      if (extension == ".msg" || extension == ".srv" || extension == ".action")
        files.insert(entry.path().string());
    }
    for (const std::string& file : files) collect(file, path);
    if (files.empty()) empty_folders_.push_back(folder);
  }

  // Among other inputs it counts as none; alone it is an error.
  void report_empty_folders() {
    for (const std::string& folder : empty_folders_) {
      report_usage(folder + ": no message definitions", "packages have a msg/ folder", usage_);
    }
  }

  void count(const std::string& name, Library& library) {
    const Message* message = library.find(name);
    if (!message) {
      unresolved_.push_back(name);
      return;
    }
    const Facts& facts = library.analysis().facts(*message);
    types_[name] = {{"fixed_length", facts.fixed_length},
                    {"has_variable_array", facts.has_variable_array},
                    {"has_data_part", facts.has_data_part()},
                    {"needs_support", facts.has_variable_array},  // former names, until the next release
                    {"supported", facts.has_data_part()},
                    {"data_fields", facts.data_fields},
                    {"md5", facts.md5}};
    ++totals_.types;
    totals_.has_variable_array += facts.has_variable_array;
    totals_.has_data_part += facts.has_data_part();
  }

  void print_json(std::ostream& out) const {
    const nlohmann::json totals = {{"types", totals_.types},
                                   {"has_variable_array", totals_.has_variable_array},
                                   {"has_data_part", totals_.has_data_part},
                                   {"needs_support", totals_.has_variable_array},  // former names
                                   {"supported", totals_.has_data_part},
                                   {"unsupported", totals_.without_data_part()}};
    const nlohmann::json result = {{"types", types_}, {"totals", totals}, {"unresolved", unresolved_}};
    out << result.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) << '\n';
  }

  void print_text(std::ostream& out) const {
    std::size_t width = 0;
    for (const auto& [name, type] : types_.items()) width = std::max(width, name.size());
    for (const auto& [name, type] : types_.items()) {
      const std::string data =
          fmt::format("{}", fmt::join(type["data_fields"].get<std::vector<std::string>>(), ", "));
      const char* kind = type["has_data_part"]        ? "supported"
                         : type["has_variable_array"] ? "unsupported"
                         : type["fixed_length"]       ? "fixed-length"
                                                      : "control only";
      const std::string line = fmt::format("{:<{}}  {:<12}  {}", name, width, kind, data);
      out << line.substr(0, line.find_last_not_of(' ') + 1) << '\n';
    }
    for (const std::string& name : unresolved_) out << fmt::format("{:<{}}  unresolved\n", name, width);
    out << fmt::format("\n{} types: {} data-heavy, of which {} supported and {} unsupported", totals_.types,
                       totals_.has_variable_array, totals_.has_data_part, totals_.without_data_part());
    out << (unresolved_.empty() ? "\n" : fmt::format("; {} unresolved\n", unresolved_.size()));
  }

  const ClassifyOptions& options_;
  Diagnostics usage_, diagnostics_;
  std::vector<Input> inputs_;
  std::vector<std::string> empty_folders_;
  nlohmann::json types_ = nlohmann::json::object();
  Totals totals_;
  std::vector<std::string> unresolved_;
};

}  // namespace

int classify(const ClassifyOptions& options, Console console) {
  return Census(options).run(console);
}

}  // namespace tzc::msggen
