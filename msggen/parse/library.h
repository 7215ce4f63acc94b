// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "model/definition.h"
#include "model/facts.h"
#include "parse/package_path.h"
#include "parse/parser.h"

namespace tzc::msggen {

struct LibraryOptions {
  SearchPath path;
  /// The packages of this machine; asked for once, at the first name that `path` does not explain.
  std::function<PackageIndex()> installed;
  bool use_installed = false;  ///< look types up in `installed` too; otherwise it serves hints only
};

/// All messages of a run by name. Reads nested types when they are first needed. A message that find()
/// returns is complete: every type inside is known, none contains itself, all fit into a ROS message.
class Library {
 public:
  Library(LibraryOptions options, Diagnostics& diagnostics);
  ~Library();

  /// Reads, parses and keeps a definition file of the package; its messages' names, complete or not.
  std::vector<std::string> add_file(const std::string& file, const std::string& package);
  std::vector<std::string> add_source(const Source& source, const std::string& package);

  /// The message if it is complete and valid; otherwise null, and all its faults are reported.
  const Message* find(const std::string& full_name);

  /// Reports a name that find() does not know and that no field asked for.
  void report_missing(const std::string& full_name);

  struct Service {
    std::string package, name;
    std::string full_name() const { return package + "/" + name; }
  };
  const std::vector<Service>& services() const { return services_; }

  Analysis& analysis() { return analysis_; }

 private:
  struct Entry;
  /// Messages of services are found when somebody asks for them, not when a field does: genmsg would not.
  enum class Wanted { field_type, any };
  Entry* known(const std::string& full_name, Wanted wanted) const;
  Entry* load(const std::string& full_name, Wanted wanted);
  bool load_from(const std::vector<std::string>& candidates, const std::string& full_name);
  void add_entry(Entry added);
  bool resolve(Entry& entry);
  bool resolve_field(const Message& message, Field& field);
  bool check_size(const Message& message);
  std::vector<std::string> folders_of(const std::string& package);
  std::string cycle_text(const std::string& closing) const;
  void report_unknown(const Message& user, const Field& field);
  std::string unknown_package_hint(const std::string& package);
  std::string unknown_type_hint(const std::string& package, const std::string& name);
  void report(const Message& message, const Field& field, std::string text, std::string hint);
  const PackageIndex& installed();

  LibraryOptions options_;
  Diagnostics& diagnostics_;
  std::map<std::string, std::unique_ptr<Entry>> entries_;
  std::vector<Service> services_;
  std::vector<std::string> resolving_;
  std::unique_ptr<PackageIndex> installed_;
  Analysis analysis_;
};

}  // namespace tzc::msggen
