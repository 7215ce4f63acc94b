// SPDX-License-Identifier: BSD-3-Clause
#include "verify/verify.h"

#include <algorithm>
#include <mutex>

namespace tzc::rewriter {
namespace {

unsigned line_at(const std::string& content, std::size_t offset) {
  return 1 + static_cast<unsigned>(
                 std::count(content.begin(), content.begin() + static_cast<long>(offset), '\n'));
}

unsigned lines_in(const std::string& text) {
  return static_cast<unsigned>(std::count(text.begin(), text.end(), '\n'));
}

/// The line of the original that became `line` of the edited file.
unsigned original_line(const std::string& original, Edits edits, unsigned line) {
  std::stable_sort(edits.begin(), edits.end(),
                   [](const Edit& a, const Edit& b) { return a.offset < b.offset; });
  int shift = 0;
  for (const Edit& edit : edits) {
    const unsigned start = line_at(original, edit.offset);
    if (static_cast<int>(start) + shift >= static_cast<int>(line)) break;
    const int grown = static_cast<int>(lines_in(edit.text)) -
                      static_cast<int>(lines_in(original.substr(edit.offset, edit.length)));
    if (static_cast<int>(start) + shift + grown >= static_cast<int>(line)) return start;
    shift += grown;
  }
  return static_cast<unsigned>(std::max(1, static_cast<int>(line) - shift));
}

void add_once(std::vector<int>& list, int item) {
  if (item >= 0 && std::find(list.begin(), list.end(), item) == list.end()) list.push_back(item);
}

}  // namespace

Expected<FileContents> Verifier::edited(const Edits& edits) const {
  FileContents contents;
  for (const auto& [file, of_file] : by_file(edits)) {
    Expected<std::string> content = apply_edits(read_(file).value_or(""), of_file);
    if (!content) return content.error();
    contents[file] = std::move(*content);
  }
  return contents;
}

std::set<std::string> Verifier::touched(const FileContents& contents) const {
  std::set<std::string> units;
  for (const auto& item : contents) {
    const auto found = facts_.units_of_file.find(item.first);
    if (found != facts_.units_of_file.end()) units.insert(found->second.begin(), found->second.end());
  }
  return units;
}

/// Whether something of the component stands on this line of the original.
bool Verifier::owns_line(int component, const std::string& file, unsigned line) const {
  const auto here = [&](const Location& where) { return where.line == line && where.file == file; };
  const auto mine = [&](const Key& key) {
    const Component* of = components_.of(key);
    return of && of->id == component;
  };
  for (const DataUse& use : facts_.data_uses)
    if (here(use.where) && mine(use.entity)) return true;
  for (const Flow& flow : facts_.flows)
    if (here(flow.where) && (mine(flow.from) || mine(flow.to))) return true;
  for (const auto& item : facts_.publishes)
    if (here(location_of(item.second.where))) {
      if (mine(item.second.publisher)) return true;
      for (const Key& key : item.second.messages)
        if (mine(key)) return true;
    }
  return false;
}

std::vector<int> Verifier::suspects_of(const Diagnostic& error,
                                       const std::map<std::string, Edits>& edits) const {
  std::vector<Location> places{error.where};
  places.insert(places.end(), error.notes.begin(), error.notes.end());
  std::vector<int> suspects;
  for (const Location& place : places) {
    const auto of_file = edits.find(place.file);
    const std::optional<std::string> original = read_(place.file);
    if (!original) continue;
    const unsigned line =
        of_file == edits.end() ? place.line : original_line(*original, of_file->second, place.line);
    std::set<int> edited;
    for (const auto& item : edits)
      for (const Edit& edit : item.second) edited.insert(edit.component);
    for (const int component : edited)
      if (component >= 0 && owns_line(component, place.file, line)) add_once(suspects, component);
    if (of_file == edits.end()) continue;
    for (const Edit& edit : of_file->second)
      if (line_at(*original, edit.offset) == line) add_once(suspects, edit.component);
  }
  return suspects;
}

unsigned Verifier::original(const std::string& file, unsigned line,
                            const std::map<std::string, Edits>& edits) const {
  const auto of_file = edits.find(file);
  const std::optional<std::string> content = of_file == edits.end() ? std::nullopt : read_(file);
  return content ? original_line(*content, of_file->second, line) : line;
}

std::vector<Diagnostic> Verifier::changed_calls(const std::string& unit, const std::vector<PackageCall>& now,
                                                const std::map<std::string, Edits>& edits) const {
  std::vector<Diagnostic> changes;
  const auto found = facts_.calls.find(unit);
  if (found == facts_.calls.end()) return changes;
  const std::vector<PackageCall>& before = found->second;
  for (std::size_t i = 0; i < before.size() || i < now.size(); ++i) {
    const bool same = i < before.size() && i < now.size() && before[i].callee == now[i].callee &&
                      before[i].callee_file == now[i].callee_file &&
                      before[i].callee_line == original(now[i].callee_file, now[i].callee_line, edits);
    if (same) continue;
    const PackageCall& call = i < now.size() ? now[i] : before[i];
    changes.push_back(
        {{call.file, call.line, 1}, "this call would choose another '" + call.callee + "' than before", {}});
    break;
  }
  return changes;
}

Expected<Verification> Verifier::run(const Edits& edits,
                                     const std::function<void(unsigned, unsigned)>& progress) const {
  Verification result;
  Expected<FileContents> contents = edited(edits);
  if (!contents) return contents.error();
  result.contents = std::move(*contents);
  ParseOptions options = options_;
  options.overlay = result.contents;
  options.skip_bodies_outside = package_dir_;  // edits can not break what system headers define
  std::vector<const CompileUnit*> units;
  const std::set<std::string> files = touched(result.contents);
  for (const CompileUnit& unit : units_)
    if (files.count(unit.file)) units.push_back(&unit);
  const std::map<std::string, Edits> edits_by_file = by_file(edits);
  std::mutex mutex;
  unsigned done = 0;
  in_parallel(jobs_, units.size(), [&](std::size_t i) {
    std::vector<PackageCall> calls;
    ParseResult parsed =
        parse(*units[i], options, [&](clang::ASTContext& ast) { calls = package_calls(ast, package_dir_); });
    if (parsed.errors.empty()) parsed.errors = changed_calls(units[i]->id(), calls, edits_by_file);
    const std::lock_guard<std::mutex> lock(mutex);
    for (const Diagnostic& error : parsed.errors)
      result.failures.push_back({error, units[i]->file, suspects_of(error, edits_by_file)});
    progress(++done, static_cast<unsigned>(units.size()));
  });
  return result;
}

}  // namespace tzc::rewriter
