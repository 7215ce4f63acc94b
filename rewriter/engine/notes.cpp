// SPDX-License-Identifier: BSD-3-Clause
#include "engine/notes.h"

#include <fstream>
#include <set>
#include <sstream>

#include "buildfiles/build_trees.h"
#include "buildfiles/compile_database.h"
#include "buildfiles/unread_files.h"
#include "model/codes.h"
#include "verify/unseen_uses.h"

namespace tzc::rewriter {
namespace {

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

void append(std::vector<Note>& notes, const std::vector<Note>& more) {
  notes.insert(notes.end(), more.begin(), more.end());
}

/// Canonical paths of the files that were read, and of units that were to be: these have notes of their own.
std::set<std::string> read_files(const UnitReading& reading, const std::vector<CompileUnit>& units) {
  std::set<std::string> read;
  for (const auto& item : reading.facts.units_of_file) read.insert(item.first);
  for (const CompileUnit& unit : units) {
    read.insert(unit.file);
    for (const std::string& source : unity_sources(unit.file)) read.insert(source);
  }
  return read;
}

}  // namespace

std::vector<Note> notes_of(const UnitReading& reading, const std::vector<CompileUnit>& units,
                           const EngineOptions& options) {
  std::vector<Note> notes;
  note_branches(compiled_by_none(reading.preprocessor.skipped, reading.preprocessor.compiled), notes);
  const std::set<std::string> read = read_files(reading, units);
  for (const std::string& package : options.packages) {
    const auto build = options.build_dirs.find(package);
    const bool has_units = build != options.build_dirs.end();
    const FolderSet generated = generated_folders(has_units ? build->second : "", package);
    if (has_units) {
      append(notes, unread_sources(package, generated, read));
      append(notes, unread_compiled(package, build->second, generated, read));
    }
    append(notes, unread_headers(package, generated, read));
  }
  return notes;
}

}  // namespace tzc::rewriter
