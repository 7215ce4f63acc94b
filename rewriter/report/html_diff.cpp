// SPDX-License-Identifier: BSD-3-Clause
#include "report/html_diff.h"

#include <fmt/format.h>

#include <algorithm>

namespace tzc::rewriter {
namespace {

constexpr std::size_t context = 3;
using Lines = std::vector<DiffLine>;

bool is_near_change(const Lines& lines, std::size_t at) {
  const std::size_t begin = at < context ? 0 : at - context, end = std::min(lines.size(), at + context + 1);
  return std::any_of(lines.begin() + begin, lines.begin() + end,
                     [](const DiffLine& line) { return line.change != LineChange::same; });
}

std::string cell(const DiffLine* line, unsigned number, const char* kind) {
  if (!line) return "<td class=\"n pad\"></td><td class=\"pad\"></td>";
  std::string text(line->text);
  while (!text.empty() && (text.back() == '\n' || text.back() == '\r')) text.pop_back();
  return fmt::format("<td class=\"n {0}\">{1}</td><td class=\"{0}\">{2}</td>", kind, number,
                     html_escaped(text));
}

std::string row(const DiffLine* left, const DiffLine* right) {
  const bool changed = !left || !right || left->change != LineChange::same;
  return "<tr>" + cell(left, left ? left->old_number : 0, changed ? "del" : "") +
         cell(right, right ? right->new_number : 0, changed ? "add" : "") + "</tr>\n";
}

/// Removed and added lines of one run of changes face each other; returns the end of the run.
std::size_t changed_rows(const Lines& lines, std::size_t at, std::string& html) {
  const auto end_of = [&](std::size_t from, LineChange change) {
    while (from < lines.size() && lines[from].change == change) ++from;
    return from;
  };
  const std::size_t middle = end_of(at, LineChange::removed), end = end_of(middle, LineChange::added);
  for (std::size_t i = 0; i < std::max(middle - at, end - middle); ++i)
    html += row(at + i < middle ? &lines[at + i] : nullptr, middle + i < end ? &lines[middle + i] : nullptr);
  return end;
}

std::string rows(const Lines& lines) {
  std::string html;
  bool cut = false;
  for (std::size_t at = 0; at < lines.size();) {
    if (lines[at].change != LineChange::same) {
      at = changed_rows(lines, at, html);
      cut = false;
    } else if (is_near_change(lines, at)) {
      html += row(&lines[at], &lines[at]);
      ++at;
      cut = false;
    } else {
      if (!cut) html += "<tr class=\"cut\"><td colspan=\"4\">&#8943;</td></tr>\n";
      cut = true;
      ++at;
    }
  }
  return html;
}

}  // namespace

std::string html_escaped(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      default:
        escaped += c;
    }
  }
  return escaped;
}

std::string html_prose(const std::string& text) {
  std::string html = html_escaped(text);
  for (std::size_t at = 0; (at = html.find('`', at)) != std::string::npos;) {
    const std::size_t end = html.find('`', at + 1);
    if (end == std::string::npos) break;
    const std::string code = "<code>" + html.substr(at + 1, end - at - 1) + "</code>";
    html.replace(at, end - at + 1, code);
    at += code.size();
  }
  return html;
}

std::string html_diff(const FileChange& change, const std::string& anchor) {
  const DiffStat stat = unified_diff(change.path, change.before, change.after, false).stat;
  return fmt::format(
      "<details class=\"file\" open id=\"{}\"><summary><h4>{}</h4><span class=\"good\">+{}</span>"
      "<span class=\"bad\">&minus;{}</span></summary>\n<table class=\"diff\"><colgroup><col "
      "style=\"width:3.6rem\"><col>"
      "<col style=\"width:3.6rem\"><col></colgroup>\n{}</table></details>\n",
      anchor, html_escaped(change.path), stat.added, stat.removed,
      rows(diff_lines(change.before, change.after)));
}

}  // namespace tzc::rewriter
