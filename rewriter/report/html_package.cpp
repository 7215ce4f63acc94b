// SPDX-License-Identifier: BSD-3-Clause
#include "report/html_package.h"

#include <fmt/format.h>

#include <algorithm>

#include "report/code_pages.h"
#include "report/html_diff.h"
#include "report/html_estimate.h"

namespace tzc::rewriter {
namespace {

const char* class_of(Level level) {
  switch (level) {
    case Level::zero_copy:
    case Level::shared:
      return "good";
    case Level::one_copy:
    case Level::copied:
      return "fair";
    case Level::plain:
      return "bad";
    case Level::not_needed:
      return "none";
  }
  return "";
}

std::string plural(unsigned n, const std::string& thing) {
  return fmt::format("{} {}{}", n, thing, n == 1 ? "" : "s");
}

class PackagePage {
 public:
  explicit PackagePage(const PackageReport& package) : package_(package), report_(package.report) {}

  std::string run() {
    html_ = fmt::format("<section>\n<h2 class=\"package\" id=\"{0}\">{0}</h2>\n<p class=\"lead\">{1}</p>\n",
                        html_escaped(report_.package), lead());
    html_ += "<div class=\"cards\">\n" + card(SiteKind::publish) + card(SiteKind::subscribe) +
             changes_card() + "</div>\n";
    html_ += html_estimate(package_);
    sites();
    notes();
    diffs();
    return html_ + "</section>\n";
  }

 private:
  std::string lead() const {
    const auto left =
        static_cast<unsigned>(std::count_if(report_.sites.begin(), report_.sites.end(), is_refusal));
    const std::string unwritten = only_shown() ? " can be ported; nothing was written." : "";
    if (left == 0)
      return "Every data-heavy site of the package" + (unwritten.empty() ? " is ported." : unwritten);
    return plural(left, "site") + (left == 1 ? " stays" : " stay") + " on TCPROS; the reasons are below." +
           (unwritten.empty() ? "" : " The others" + unwritten);
  }

  /// The changes are those of a dry run.
  bool only_shown() const { return !package_.changes.empty() && !package_.written; }

  std::string card(SiteKind kind) const {
    unsigned total = 0;
    std::string bar, legend;
    for (const Level level : levels_of(kind)) {
      const unsigned n = count(report_, kind, level);
      if (n == 0) continue;
      total += n;
      bar += fmt::format("<i class=\"{}\" style=\"flex:{}\"></i>", class_of(level), n);
      legend += fmt::format("{}<span class=\"{}\">{} {}</span>", legend.empty() ? "" : " &middot; ",
                            class_of(level), n, name_of(level));
    }
    return fmt::format("<div class=\"card\"><b>{}</b>{} sites<div class=\"bar\">{}</div><p>{}</p></div>\n",
                       total, name_of(kind), bar, legend.empty() ? "none in this package" : legend);
  }

  std::string changes_card() const {
    const DiffStat stat = package_.stat();
    return fmt::format(
        "<div class=\"card\"><b>{}</b>file{} {}<p><span class=\"good\">+{} lines</span> &middot; "
        "<span class=\"bad\">&minus;{} lines</span></p></div>\n",
        stat.files, stat.files == 1 ? "" : "s", only_shown() ? "to change" : "changed", stat.added,
        stat.removed);
  }

  std::string anchor(const std::string& path) const { return html_escaped(report_.package + "/" + path); }

  std::string place(const Location& where) const {
    const std::string file = relative_file(report_, where.file);
    const std::string text =
        fmt::format("<code>{}:{}:{}</code>", html_escaped(file), where.line, where.column);
    const bool changed = std::any_of(package_.changes.begin(), package_.changes.end(),
                                     [&](const FileChange& change) { return change.path == file; });
    return changed ? fmt::format("<a href=\"#{}\">{}</a>", anchor(file), text) : text;
  }

  void sites() {
    html_ += "<h3>Sites</h3>\n";
    if (report_.sites.empty()) {
      html_ += "<p>No advertise, publish or subscribe site.</p>\n";
      return;
    }
    html_ +=
        "<table "
        "class=\"sites\"><thead><tr><th>where</th><th>kind</th><th>message</th><th>topic</th><th>level</th>"
        "</tr></thead>\n<tbody>\n";
    for (const Site& site : report_.sites) site_row(site);
    html_ += "</tbody></table>\n";
  }

  void site_row(const Site& site) {
    const std::string topic = site.topic ? "<code>" + html_escaped(*site.topic) + "</code>"
                                         : "<span class=\"none\">not a constant</span>";
    const std::string why = reasons(site);
    html_ += fmt::format(
        "<tr class=\"site{}\" data-kind=\"{}\" "
        "data-level=\"{}\"><td>{}</td><td>{}</td><td><code>{}</code></td>"
        "<td>{}</td><td class=\"level {}\">{}</td></tr>\n",
        why.empty() ? "" : " has-why", name_of(site.kind), name_of(site.level), place(site.where),
        name_of(site.kind), html_escaped(site.message_type), topic, class_of(site.level),
        name_of(site.level));
    if (!why.empty()) html_ += "<tr class=\"why\"><td></td><td colspan=\"4\">" + why + "</td></tr>\n";
  }

  std::string reasons(const Site& site) const {
    std::string html;
    if (!site.code.empty()) {
      const CodeInfo* info = find_code(site.code);
      const std::string title = info ? std::string(info->title) : "";
      html += fmt::format("<b>{}</b> {}", site.code, html_prose(site.reason.empty() ? title : site.reason));
      if (site.suppressed)
        html +=
            fmt::format(" <span class=\"none\">(suppressed: {})</span>", html_prose(site.suppression_reason));
    } else {
      html += html_prose(site.reason);
    }
    const std::vector<FlowStep> chain = shown_flow_path(site);
    if (!chain.empty()) html += "<ol>";
    for (const FlowStep& step : chain)
      html += fmt::format("<li>{} {}</li>", place(step.where), html_prose(step.what));
    if (!chain.empty()) html += "</ol>";
    if (!site.memory_note.empty())
      html += fmt::format("<div class=\"memory\">Memory: {}</div>", html_prose(site.memory_note));
    return html;
  }

  void notes() {
    if (report_.notes.empty()) return;
    html_ += "<h3>Notes</h3>\n<ul>\n";
    for (const Note& note : report_.notes)
      html_ += fmt::format("<li><b>{}</b> {} {}</li>\n", note.code, note.where ? place(*note.where) : "",
                           html_prose(note.text));
    html_ += "</ul>\n";
  }

  void diffs() {
    if (package_.changes.empty()) return;
    html_ += "<h3>Changes</h3>\n";
    for (const FileChange& change : package_.changes) html_ += html_diff(change, anchor(change.path));
  }

  const PackageReport& package_;
  const Report& report_;
  std::string html_;
};

}  // namespace

std::string html_package(const PackageReport& package) {
  return PackagePage(package).run();
}

}  // namespace tzc::rewriter
