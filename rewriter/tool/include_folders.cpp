// SPDX-License-Identifier: BSD-3-Clause
#include "tool/include_folders.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "buildfiles/package_xml.h"
#include "edits/files.h"
#include "model/folder_set.h"
#include "tool/text_files.h"

namespace tzc::rewriter {
namespace fs = std::filesystem;
namespace {

const char* const any_folder = "*";

void replace_all(std::string& text, const std::string& old, const std::string& replacement) {
  for (std::size_t at = text.find(old); at != std::string::npos; at = text.find(old, at + replacement.size()))
    text.replace(at, old.size(), replacement);
}

bool is_of_path(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) || std::string("_-+./${}*").find(c) != std::string::npos;
}

/// The package that a file is part of; empty: none.
std::string package_of(const std::string& file) {
  std::error_code failed;
  for (fs::path folder = fs::path(file).parent_path(); folder.has_relative_path();
       folder = folder.parent_path())
    if (fs::exists(folder / "package.xml", failed)) return folder.string();
  return "";
}

}  // namespace

void IncludeFolders::add(const std::string& cmake_file, const std::string& project, PathEnds& ends) {
  const Expected<std::string> read = read_file(cmake_file);
  std::string text = read ? *read : "";
  replace_all(text, "${PROJECT_NAME}", project);
  for (auto begin = text.begin(); begin != text.end();) {
    const auto end = std::find_if_not(begin, text.end(), is_of_path);
    fs::path path(begin, end);
    if (!path.has_filename()) path = path.parent_path();
    ends.names.insert(path.filename().string());
    ends.pairs.insert((path.parent_path().filename() / path.filename()).string());
    begin = std::find_if(end, text.end(), is_of_path);
  }
}

const IncludeFolders::PathEnds& IncludeFolders::ends_in(const std::string& package) {
  const auto known = ends_.emplace(package, PathEnds());
  PathEnds& ends = known.first->second;
  if (!known.second || package.empty()) return ends;
  const Expected<PackageXml> manifest = read_package_xml(package);
  const std::string project = manifest ? manifest->name : fs::path(package).filename().string();
  TextFiles files(
      [&](const std::string& file) {
        ends.is_known = true;
        add(file, project, ends);
      },
      {},
      [](const std::string& name) {
        return name == "CMakeLists.txt" || name.find(".cmake") != std::string::npos;
      });
  files.walk(package);
  if (ends.names.count(any_folder)) ends.is_known = false;
  return ends;
}

bool IncludeFolders::may_serve(const std::string& folder, const std::string& package,
                               const std::string& file) {
  const fs::path path(folder);
  const std::string name = path.filename(), parent = path.parent_path().filename();
  if (name == "include" || !is_below(folder, package)) return true;
  const PathEnds& own = ends_in(package);
  if (!own.is_known || own.names.count(name)) return true;
  const PathEnds& other = ends_in(package_of(file));
  return !other.is_known || other.pairs.count(parent + "/" + name) ||
         std::any_of(other.pairs.begin(), other.pairs.end(), [&](const std::string& pair) {
           return pair.find('$') != std::string::npos && fs::path(pair).filename() == name;
         });
}

}  // namespace tzc::rewriter
