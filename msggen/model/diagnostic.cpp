// SPDX-License-Identifier: BSD-3-Clause
#include "model/diagnostic.h"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

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

// A terminal must not act on what a definition contains, and a line of a megabyte is useless.
std::string printable(const std::string& line) {
  constexpr std::size_t longest = 240;
  std::string clean = line.substr(0, longest);
  for (char& c : clean) {
    if (static_cast<unsigned char>(c) < 0x20 && c != '\t') c = '?';
  }
  return clean;
}

std::string excerpt(const Diagnostic& d) {
  if (d.source_line.empty()) return {};
  std::string line = printable(d.source_line);
  std::string caret = "^";
  if (d.width > 1) caret.append(std::min<std::size_t>(d.width - 1, 120), '~');
  return fmt::format("  {}\n  {}{}\n", line, padding(line, d.at.column ? d.at.column - 1 : 0), caret);
}

}  // namespace

std::string render(const Diagnostic& d, Severity severity) {
  std::string where = d.file.empty() ? "tzc-msggen" : d.file;
  if (d.at.line) where += fmt::format(":{}:{}", d.at.line, d.at.column);
  const char* const word = severity == Severity::error ? "error" : "warning";
  std::string text = fmt::format("{}: {}: {}\n{}", where, word, d.message, excerpt(d));
  if (!d.hint.empty()) text += fmt::format("  hint: {}\n", d.hint);
  return text;
}

void Diagnostics::report(Diagnostic diagnostic) {
  auto same = [&](const Diagnostic& other) { return key(other) == key(diagnostic); };
  if (std::none_of(all_.begin(), all_.end(), same)) all_.push_back(std::move(diagnostic));
}

std::vector<Diagnostic> Diagnostics::sorted() const {
  std::vector<Diagnostic> result = all_;
  std::stable_sort(result.begin(), result.end(),
                   [](const auto& a, const auto& b) { return key(a) < key(b); });
  return result;
}

}  // namespace tzc::msggen
