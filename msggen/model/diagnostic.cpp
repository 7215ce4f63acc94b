// SPDX-License-Identifier: BSD-3-Clause
#include "model/diagnostic.h"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "model/printable.h"

namespace tzc::msggen {
namespace {

auto key(const Diagnostic& d) {
  return std::tie(d.file, d.at.line, d.at.column, d.message);
}

bool is_continuation_byte(char c) {
  return (static_cast<unsigned char>(c) & 0xC0) == 0x80;
}

// The first `count` characters of the line as blanks; tabs stay tabs, so that the caret lands under its
// character.
std::string padding(const std::string& line, std::size_t count) {
  std::string blanks;
  for (std::size_t i = 0; i < line.size() && count > 0; ++i) {
    if (is_continuation_byte(line[i])) continue;
    blanks += line[i] == '\t' ? '\t' : ' ';
    --count;
  }
  return blanks;
}

// A definition of a megabyte in one line is useless in a message.
constexpr std::size_t longest_line = 240, longest_text = 2000;

std::string excerpt(const Diagnostic& d) {
  if (d.source_line.empty()) return {};
  const std::string line = printable(d.source_line, longest_line);
  std::string caret = "^";
  if (d.width > 1) caret.append(std::min<std::size_t>(d.width - 1, 120), '~');
  return fmt::format("  {}\n  {}{}\n", line, padding(line, d.at.column ? d.at.column - 1 : 0), caret);
}

Diagnostic there_are_more(const std::string& file) {
  Diagnostic d;
  d.file = file;
  d.message = fmt::format("only the first {} faults of this file are shown", Diagnostics::most_of_a_file);
  return d;
}

}  // namespace

// A terminal must not act on what a definition, or its file's name, contains.
std::string render(const Diagnostic& d, Severity severity) {
  std::string where = d.file.empty() ? "tzc-msggen" : printable(d.file, longest_text);
  if (d.at.line) where += fmt::format(":{}:{}", d.at.line, d.at.column);
  const char* const word = severity == Severity::error ? "error" : "warning";
  std::string text =
      fmt::format("{}: {}: {}\n{}", where, word, printable(d.message, longest_text), excerpt(d));
  if (!d.hint.empty()) text += fmt::format("  hint: {}\n", printable(d.hint, longest_text));
  return text;
}

void Diagnostics::report(Diagnostic diagnostic) {
  ++reported_;
  const Diagnostic& d = diagnostic;
  if (has_enough_of(d.file) || !known_.emplace(d.file, d.at.line, d.at.column, d.message).second) return;
  if (++found_in_file_[d.file] <= most_of_a_file || d.file.empty()) all_.push_back(std::move(diagnostic));
}

// What belongs to no file, that is to the command line, has no limit.
bool Diagnostics::has_enough_of(const std::string& file) const {
  const auto found = found_in_file_.find(file);
  return !file.empty() && found != found_in_file_.end() && found->second > most_of_a_file;
}

std::vector<Diagnostic> Diagnostics::sorted() const {
  std::vector<Diagnostic> result = all_;
  std::stable_sort(result.begin(), result.end(),
                   [](const auto& a, const auto& b) { return key(a) < key(b); });
  for (const auto& [file, found] : found_in_file_) {
    if (!has_enough_of(file)) continue;
    auto end = std::upper_bound(result.begin(), result.end(), file,
                                [](const std::string& name, const Diagnostic& d) { return name < d.file; });
    result.insert(end, there_are_more(file));
  }
  return result;
}

}  // namespace tzc::msggen
