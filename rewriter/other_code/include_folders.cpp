// SPDX-License-Identifier: BSD-3-Clause
#include "other_code/include_folders.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <string_view>

#include "buildfiles/cmake_project.h"
#include "buildfiles/package_xml.h"
#include "edits/files.h"
#include "model/folder_set.h"
#include "other_code/text_files.h"

namespace tzc::rewriter {
namespace fs = std::filesystem;
namespace {

const char* const any_folder = "*";

void replace_all(std::string& text, const std::string& old, const std::string& replacement) {
  for (std::size_t at = text.find(old); at != std::string::npos; at = text.find(old, at + replacement.size()))
    text.replace(at, old.size(), replacement);
}

bool is_of_path(char c) {
  constexpr std::string_view others = "_-+./${}*";
  return std::isalnum(static_cast<unsigned char>(c)) || others.find(c) != std::string_view::npos;
}

bool is_variable(const std::string& part) {
  return part.find('$') != std::string::npos;
}

/// The package that a file is part of; empty: none.
std::string package_of(const std::string& file) {
  std::error_code failed;
  for (fs::path folder = fs::path(file).parent_path(); folder.has_relative_path();
       folder = folder.parent_path())
    if (fs::exists(folder / "package.xml", failed)) return folder.string();
  return "";
}

/// By their names, and those that include() brings in, which may have any.
std::set<std::string> cmake_files_of(const std::string& package) {
  std::set<std::string> found;
  TextFiles files([&](const std::string& file) { found.insert(file); }, {},
                  [](const std::string& name) {
                    return has_cmake_name(name) || name.find(".cmake") != std::string::npos;
                  });
  files.walk(package);
  if (const Expected<CmakeProject> project = load_cmake_project(package))
    for (const CmakeListFile& file : project->files) found.insert(file.path);
  return found;
}

}  // namespace

void IncludeFolders::add(const std::string& cmake_file, const std::string& project, Words& words) {
  const Expected<std::string> read = read_file(cmake_file);
  std::string text = read ? *read : "";
  replace_all(text, "${PROJECT_NAME}", project);
  bool are_suffixes = false;
  for (auto begin = text.begin(); begin != text.end();) {
    const auto end = std::find_if_not(begin, text.end(), is_of_path);
    fs::path path(begin, end);
    if (!path.has_filename()) path = path.parent_path();
    const std::string name = path.filename(), parent = path.parent_path().filename();
    words.last.insert(name);
    if (path.has_parent_path()) words.pairs.emplace(parent, name);
    words.has_patterns |= path.has_parent_path() && name == any_folder;
    are_suffixes |= name == "PATH_SUFFIXES";
    if (are_suffixes) words.suffixes.insert(name);
    begin = std::find_if(end, text.end(), is_of_path);
    are_suffixes &= std::find(end, begin, ')') == begin;
  }
}

const IncludeFolders::Words& IncludeFolders::words_of(const std::string& package) {
  const auto known = words_.emplace(package, Words());
  Words& words = known.first->second;
  if (!known.second || package.empty()) return words;
  const Expected<PackageXml> manifest = read_package_xml(package);
  const std::string project = manifest ? manifest->name : fs::path(package).filename().string();
  for (const std::string& file : cmake_files_of(package)) {
    words.is_known = true;
    add(file, project, words);
  }
  return words;
}

/// A path may be put together: "lib/${name}" and the name, or a name of PATH_SUFFIXES.
bool IncludeFolders::Words::may_name(const std::string& parent, const std::string& name) const {
  if (!is_known || has_patterns || pairs.count({parent, name})) return true;
  const bool has_name = last.count(name) != 0;
  return suffixes.count(name) != 0 || std::any_of(pairs.begin(), pairs.end(), [&](const auto& pair) {
           return (is_variable(pair.first) && pair.second == name) ||
                  (has_name && pair.first == parent && is_variable(pair.second));
         });
}

bool IncludeFolders::may_serve(const std::string& folder, const std::string& package,
                               const std::string& file) {
  const fs::path path(folder);
  const std::string name = path.filename(), parent = path.parent_path().filename();
  if (name == "include" || !is_below(folder, package)) return true;
  const Words& own = words_of(package);
  const bool is_word =
      path.parent_path() == package && (own.last.count(name) != 0 || own.last.count(any_folder) != 0);
  return is_word || own.may_name(parent, name) || words_of(package_of(file)).may_name(parent, name);
}

}  // namespace tzc::rewriter
