// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <vector>

#include "report/code_pages.h"
#include "report/estimate.h"
#include "report/output.h"

namespace tzc::rewriter {
namespace {

constexpr const char* bold = "1";
constexpr const char* dim = "2";

const char* colour_of(Level level) {
  switch (level) {
    case Level::zero_copy:
    case Level::shared:
      return "32";
    case Level::one_copy:
    case Level::copied:
      return "33";
    case Level::plain:
      return "31";
    case Level::not_needed:
      return dim;
  }
  return "";
}

/// The cells of one site, in the order of the columns.
using Row = std::array<std::string, 5>;

class TextReport {
 public:
  TextReport(const PackageReport& package, const TextStyle& style)
      : package_(package), report_(package.report), style_(style) {}

  std::string run() {
    text_ = painted(bold, report_.package) + "\n";
    table();
    notes();
    summary();
    return text_;
  }

 private:
  std::string painted(const char* colour, const std::string& text) const {
    return style_.colour ? fmt::format("\033[{}m{}\033[0m", colour, text) : text;
  }

  std::string place(const Location& where) const {
    return fmt::format("{}:{}:{}", relative_file(report_, where.file), where.line, where.column);
  }

  Row row(const Site& site) const {
    return {place(site.where), name_of(site.kind), site.message_type, site.topic.value_or("-"),
            name_of(site.level)};
  }

  /// By file, as one reads the source.
  std::vector<const Site*> ordered() const {
    std::vector<const Site*> sites;
    for (const Site& site : report_.sites) sites.push_back(&site);
    std::stable_sort(sites.begin(), sites.end(), [](const Site* a, const Site* b) {
      return std::tie(a->where.file, a->where.line, a->where.column) <
             std::tie(b->where.file, b->where.line, b->where.column);
    });
    return sites;
  }

  void table() {
    if (report_.sites.empty()) text_ += "  no advertise, publish or subscribe site\n";
    std::array<std::size_t, 5> widths{};
    const std::vector<const Site*> sites = ordered();
    for (const Site* site : sites) {
      const Row cells = row(*site);
      for (std::size_t i = 0; i < cells.size(); ++i) widths[i] = std::max(widths[i], cells[i].size());
    }
    for (const Site* site : sites) {
      const Row cells = row(*site);
      text_ += "  ";
      for (std::size_t i = 0; i + 1 < cells.size(); ++i)
        text_ += fmt::format("{:<{}}  ", cells[i], widths[i]);
      text_ += painted(colour_of(site->level), cells.back()) + "\n";
      remark(*site);
    }
  }

  void remark(const Site& site) {
    if (site.code.empty() && !site.reason.empty()) text_ += "      " + site.reason + "\n";
    if (site.code.empty()) return;
    const CodeInfo* info = find_code(site.code);
    text_ +=
        fmt::format("      {} {}{}\n", painted(bold, site.code),
                    !site.reason.empty() ? site.reason : std::string(info ? info->title : ""),
                    site.suppressed ? painted(dim, " (suppressed: " + site.suppression_reason + ")") : "");
    if (!style_.chains) return;
    for (const FlowStep& step : shown_flow_path(site))
      text_ += painted(dim, fmt::format("        {}: {}", place(step.where), step.what)) + "\n";
  }

  /// What is said of many whole files is said once, with their folders; the machine-readable reports name each.
  void notes() {
    constexpr std::size_t many = 5;
    const auto said_alike = [](const Note& a, const Note& b) {
      return is_of_file(a) && is_of_file(b) && a.code == b.code && a.text == b.text;
    };
    for (auto note = report_.notes.begin(); note != report_.notes.end();) {
      const auto end = std::find_if_not(note, report_.notes.end(),
                                        [&](const Note& other) { return said_alike(*note, other); });
      if (end - note >= static_cast<std::ptrdiff_t>(many))
        note_of_files({note, end});
      else
        std::for_each(note, std::max(end, note + 1), [this](const Note& one) { note_lines(one); });
      note = std::max(end, note + 1);
    }
  }

  static bool is_of_file(const Note& note) {
    return note.where && note.where->line == 1 && note.where->column == 1;
  }

  void note_lines(const Note& note) {
    const std::string where = note.where ? place(*note.where) + ": " : "";
    text_ += fmt::format("  {} {}{}\n", painted(bold, note.code), where, note.text);
  }

  void note_of_files(const std::vector<Note>& notes) {
    std::map<std::string, unsigned> folders;
    for (const Note& note : notes) {
      const std::string file = relative_file(report_, note.where->file);
      const std::size_t slash = file.rfind('/');
      ++folders[slash == std::string::npos ? "." : file.substr(0, slash)];
    }
    text_ += fmt::format("  {} {} files, of each: {}\n", painted(bold, notes[0].code), notes.size(),
                         notes[0].text);
    for (const auto& [folder, count] : folders) text_ += fmt::format("      {}: {}\n", folder, count);
  }

  void summary() {
    const std::size_t before = text_.size();
    for (const SiteKind kind : {SiteKind::publish, SiteKind::subscribe}) counts(kind);
    const DiffStat stat = package_.stat();
    if (stat.files > 0)
      text_ += fmt::format("  {:<10} {} file{}, {} {}\n", "changes", stat.files, stat.files == 1 ? "" : "s",
                           painted("32", fmt::format("+{}", stat.added)),
                           painted("31", fmt::format("-{}", stat.removed)));
    if (const std::string estimate = text_estimate(package_); !estimate.empty())
      text_ +=
          fmt::format("  {:<10} {}; for one message of each site and one subscriber\n", "estimate", estimate);
    if (text_.size() > before) text_.insert(before, "\n");
  }

  void counts(SiteKind kind) {
    std::string parts;
    unsigned total = 0;
    for (const Level level : levels_of(kind)) {
      const unsigned n = count(report_, kind, level);
      total += n;
      if (n > 0)
        parts +=
            (parts.empty() ? "" : ", ") + painted(colour_of(level), fmt::format("{} {}", n, name_of(level)));
    }
    if (total > 0)
      text_ += fmt::format("  {:<10} {} site{}: {}\n", name_of(kind), total, total == 1 ? "" : "s", parts);
  }

  const PackageReport& package_;
  const Report& report_;
  const TextStyle& style_;
  std::string text_;
};

}  // namespace

std::string to_text(const PackageReport& package, const TextStyle& style) {
  return TextReport(package, style).run();
}

}  // namespace tzc::rewriter
