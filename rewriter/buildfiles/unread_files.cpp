// SPDX-License-Identifier: BSD-3-Clause
#include "buildfiles/unread_files.h"

#include <algorithm>
#include <filesystem>
#include <regex>
#include <sstream>

#include "buildfiles/compile_database.h"
#include "edits/files.h"
#include "model/codes.h"

namespace tzc::rewriter {
namespace fs = std::filesystem;
namespace {

/// Sorted. Without what is hidden, and without links to files of the package, which are among them by their own names.
std::set<std::string> files_of(const std::string& package_dir, const FolderSet& generated) {
  std::set<std::string> files;
  std::error_code failed, ignored;
  const auto options = fs::directory_options::skip_permission_denied;
  for (fs::recursive_directory_iterator at(package_dir, options, failed), end; !failed && at != end;
       at.increment(failed)) {
    const std::string path = at->path();
    if (at->is_directory(ignored)) {
      if (at->path().filename().string().front() == '.') at.disable_recursion_pending();
    } else if (at->is_regular_file(ignored) && !generated.hold(path) &&
               !(at->is_symlink(ignored) && is_below(canonical_path(path), package_dir))) {
      files.insert(path);
    }
  }
  return files;
}

Note note_on_source(const std::string& file, const std::string& package_dir) {
  const bool leads_out = !is_below(canonical_path(file), package_dir);
  return {codes::TZC3001, Location{file, 1, 1},
          leads_out ? "this link leads to a file outside of the package, which was not looked at"
                    : "no target of this configuration compiles this file"};
}

bool ends_with(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

/// By the compiler, or by the language that it is told: a C compiler stands in front of C.
bool compiles_cpp(const CompileCommand& command) {
  const std::vector<std::string>& words = command.arguments;
  const auto first_flag = std::find_if(words.begin(), words.end(),
                                       [](const std::string& word) { return word.rfind('-', 0) == 0; });
  const bool told = std::find(first_flag, words.end(), "c++") != words.end();
  return told || std::any_of(words.begin(), first_flag,
                             [](const std::string& word) { return ends_with(word, "++"); });
}

/// set_source_files_properties(node.impl PROPERTIES LANGUAGE CXX). Headers and CUDA sources have notes of their own.
bool has_strange_name(const CompileCommand& command) {
  const std::string& file = command.canonical;
  return !is_cpp_source(file) && !is_cpp_header(file) && !is_cuda_source(file) && compiles_cpp(command);
}

Note note_on_strange_name(const std::string& file, const std::string& lines) {
  return {codes::TZC3001, Location{file, 1, 1},
          "a target compiles this file as C++, and it was not looked at because its name is none of a C++ "
          "source; possible sites in lines " +
              lines};
}

/// "PATH" of a line "NAME:STATIC=PATH" of CMake's cache; empty: the line is of something else.
std::string value_of(const std::string& line, const std::string& name) {
  const std::string begin = name + ":STATIC=";
  return line.rfind(begin, 0) == 0 ? line.substr(begin.size()) : "";
}

/// Where the targets of a package are built, canonical, by CMake's cache of the folder or of the nearest one above it; empty: it does not say.
std::string binary_folder(const std::string& package_dir, const std::string& build_dir) {
  fs::path folder = build_dir;
  while (folder.has_relative_path() && !is_there(folder / "CMakeCache.txt")) folder = folder.parent_path();
  const Expected<std::string> cache = read_file(folder / "CMakeCache.txt");
  static const std::string source_end = "_SOURCE_DIR";
  std::string project;
  for (const bool finds_project : {true, false}) {
    std::istringstream lines(cache ? *cache : "");
    for (std::string line; std::getline(lines, line);) {
      const std::string name = line.substr(0, line.find(':'));
      if (!finds_project) {
        if (const std::string found = value_of(line, project + "_BINARY_DIR"); !found.empty())
          return canonical_path(found);
      } else if (ends_with(name, source_end) && canonical_path(value_of(line, name)) == package_dir) {
        project = name.substr(0, name.size() - source_end.size());
      }
    }
    if (project.empty()) return "";
  }
  return "";
}

/// A line of a comment, as documentation has them.
bool is_comment(const std::string& line) {
  static const std::regex comment("^\\s*(//|/\\*|\\* )");
  return std::regex_search(line, comment);
}

}  // namespace

std::vector<Note> unread_sources(const std::string& package_dir, const FolderSet& generated,
                                 const std::set<std::string>& read) {
  std::vector<Note> notes;
  for (const std::string& file : files_of(package_dir, generated))
    if (is_cpp_source(file) && read.count(canonical_path(file)) == 0)
      notes.push_back(note_on_source(file, package_dir));
    else if (const std::string lines = is_cuda_source(file) ? lines_with_sites(file) : ""; !lines.empty())
      notes.push_back(
          {codes::TZC3001, Location{file, 1, 1}, "CUDA is not analysed; possible sites in lines " + lines});
  return notes;
}

std::vector<Note> unread_compiled(const std::string& package_dir, const std::string& build_dir,
                                  const FolderSet& generated, const std::set<std::string>& read) {
  const Expected<std::vector<CompileCommand>> commands = read_compile_commands(build_dir);
  if (!commands) return {};
  const auto is_own = [&](const std::string& file) {
    return is_below(file, package_dir) && !generated.hold(file);
  };
  std::set<std::string> target_dirs, others, strange;
  for (const CompileCommand& command : *commands) {
    if (!is_own(command.canonical)) continue;
    if (!command.target_dir.empty()) target_dirs.insert(command.target_dir);
    if (has_strange_name(command) && read.count(command.canonical) == 0) strange.insert(command.canonical);
  }
  // A target may be made of nothing but sources that lie elsewhere.
  const std::string binary = binary_folder(package_dir, build_dir);
  const auto is_of_package = [&](const std::string& target_dir) {
    return target_dirs.count(target_dir) != 0 ||
           (!binary.empty() && (target_dir == binary || is_below(target_dir, binary)));
  };
  for (const CompileCommand& command : *commands)
    if (is_of_package(command.target_dir) && !is_own(command.canonical) && is_cpp_source(command.canonical) &&
        unity_sources(command.file).empty() && read.count(command.canonical) == 0)
      others.insert(command.canonical);
  std::vector<Note> notes;
  for (const std::string& file : others)
    if (const std::string lines = lines_with_sites(file); !lines.empty())
      notes.push_back({codes::TZC3001, Location{package_dir + "/CMakeLists.txt", 1, 1},
                       "a target compiles " + file +
                           ", which is generated or lies outside of the package, and was not looked at; "
                           "possible sites in lines " +
                           lines});
  for (const std::string& file : strange)
    if (const std::string lines = lines_with_sites(file); !lines.empty())
      notes.push_back(note_on_strange_name(file, lines));
  return notes;
}

std::vector<Note> unread_headers(const std::string& package_dir, const FolderSet& generated,
                                 const std::set<std::string>& read) {
  std::vector<Note> notes;
  for (const std::string& file : files_of(package_dir, generated)) {
    if (!is_cpp_header(file) || read.count(canonical_path(file)) != 0) continue;
    if (const std::string lines = lines_with_sites(file); !lines.empty())
      notes.push_back(
          {codes::TZC3001, Location{file, 1, 1},
           "no unit of the package that was read includes this header; possible sites in lines " + lines});
  }
  return notes;
}

std::string lines_with_sites(const std::string& file) {
  static const std::regex site("\\b(publish|advertise|subscribe)\\w*\\s*[<(]");
  const Expected<std::string> text = read_file(file);
  std::istringstream stream(text ? *text : "");
  std::string lines, line;
  for (unsigned number = 1; std::getline(stream, line); ++number)
    if (std::regex_search(line, site) && !is_comment(line))
      lines += (lines.empty() ? "" : ", ") + std::to_string(number);
  return lines;
}

}  // namespace tzc::rewriter
