// SPDX-License-Identifier: BSD-3-Clause
#include "other_code/copied_definitions.h"

#include <filesystem>
#include <map>
#include <set>

#include "buildfiles/find_packages.h"
#include "buildfiles/package_xml.h"
#include "edits/files.h"
#include "edits/source_text.h"
#include "other_code/text_files.h"

namespace tzc::rewriter {
namespace fs = std::filesystem;
namespace {

std::string name_of(const std::string& package_dir) {
  const Expected<PackageXml> package = read_package_xml(package_dir);
  return package ? package->name : "";
}

std::map<std::string, TextRange> definitions_of(const std::string& file) {
  const Expected<std::string> text = read_file(file);
  return text ? definitions_in(without_comments(*text)) : std::map<std::string, TextRange>();
}

/// Headers may have any name; these files, which many packages have, are none.
bool may_be_header(const std::string& name) {
  static const std::set<std::string> others = {".txt", ".xml", ".md", ".rst", ".py"};
  return !is_cpp_source(name) && others.count(fs::path(name).extension()) == 0;
}

/// The headers of packages, by the last part of their names.
class Headers {
 public:
  explicit Headers(const FolderSet& packages) {
    TextFiles files([this](const std::string& file) { by_name_[fs::path(file).filename()].push_back(file); },
                    {}, may_be_header);
    for (const std::string& package : packages) files.walk(package);
  }

  bool has(const std::string& name) const { return by_name_.count(name) != 0; }

  void compare(const std::string& other, std::vector<CopiedDefinition>& copied) const {
    const std::map<std::string, TextRange> theirs = definitions_of(other);
    for (const std::string& header : by_name_.at(fs::path(other).filename()))
      for (const auto& [words, range] : definitions_of(header))
        if (theirs.count(words)) copied.push_back({header, range.begin, range.end, other});
  }

 private:
  std::map<std::string, std::vector<std::string>> by_name_;
};

}  // namespace

std::vector<CopiedDefinition> copied_definitions(const FolderSet& packages, const std::string& root) {
  std::set<std::string> names;
  for (const std::string& package : packages) names.insert(name_of(package));
  std::vector<CopiedDefinition> copied;
  const Expected<std::vector<std::string>> others = find_packages_at(root);
  if (!others) return copied;
  const Headers headers(packages);
  TextFiles files([&](const std::string& file) { headers.compare(file, copied); }, packages,
                  [&](const std::string& name) { return headers.has(name); });
  for (const std::string& other : *others)
    if (names.count(name_of(other)) == 0) files.walk(other);
  return copied;
}

}  // namespace tzc::rewriter
