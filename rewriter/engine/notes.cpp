// SPDX-License-Identifier: BSD-3-Clause
#include "engine/notes.h"

#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "buildfiles/compile_database.h"
#include "edits/files.h"
#include "model/codes.h"
#include "verify/unseen_uses.h"

namespace tzc::rewriter {
namespace {

namespace fs = std::filesystem;

std::string text_of(const Place& place) {
  std::ifstream file(place.file, std::ios::binary);
  std::ostringstream content;
  content << file.rdbuf();
  const std::string text = content.str();
  return place.begin < text.size() ? text.substr(place.begin, place.end - place.begin) : "";
}

bool has_site(const std::string& text) {
  for (const char* word : {"publish(", "advertise", "subscribe"})
    if (text.find(word) != std::string::npos) return true;
  return false;
}

void note_branches(const std::vector<Place>& unseen, std::vector<Note>& notes) {
  for (const Place& branch : unseen) {
    if (!has_site(text_of(branch))) continue;
    notes.push_back(
        {codes::TZC3002, location_of(branch),
         "this preprocessor branch is not compiled in this configuration; its sites were not looked at"});
  }
}

std::set<std::string> compiled_by(const std::vector<CompileUnit>& units) {
  std::set<std::string> compiled;
  for (const CompileUnit& unit : units) {
    compiled.insert(unit.file);
    for (const std::string& source : unity_sources(unit.file)) compiled.insert(source);
  }
  return compiled;
}

void note_sources(const std::string& package, const std::string& build_dir,
                  const std::set<std::string>& compiled, std::vector<Note>& notes) {
  std::error_code failed;
  fs::recursive_directory_iterator entry(package, failed), end;
  for (; !failed && entry != end; entry.increment(failed)) {
    const std::string path = entry->path().string();
    const std::string name = entry->path().filename().string();
    if (entry->is_directory() && (path == build_dir || name[0] == '.')) {
      entry.disable_recursion_pending();
    } else if (entry->is_regular_file() && is_cpp_source(path) && compiled.count(path) == 0) {
      notes.push_back(not_compiled(path));
    }
  }
}

}  // namespace

std::vector<Note> notes_of(const UnitReading& reading, const std::vector<CompileUnit>& units,
                           const EngineOptions& options) {
  std::vector<Note> notes;
  note_branches(compiled_by_none(reading.skipped, reading.compiled), notes);
  const std::set<std::string> compiled = compiled_by(units);
  for (const auto& [package, build_dir] : options.build_dirs)
    note_sources(package, build_dir, compiled, notes);
  return notes;
}

}  // namespace tzc::rewriter
