// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>

#include "report/estimate.h"
#include "report/html_diff.h"
#include "report/html_estimate.h"
#include "report/html_package.h"
#include "report/html_script.h"
#include "report/html_style.h"
#include "report/output.h"
#include "report/utf8.h"

namespace tzc::rewriter {
namespace {

/// The numbers of one package, or of all.
struct Totals {
  unsigned publish = 0, published_in_memory = 0, subscribe = 0, read_in_memory = 0, left = 0;
  EstimateSum copies;
  DiffStat stat;

  void add(const Totals& other) {
    publish += other.publish;
    published_in_memory += other.published_in_memory;
    subscribe += other.subscribe;
    read_in_memory += other.read_in_memory;
    left += other.left;
    copies.before += other.copies.before;
    copies.after += other.copies.after;
    stat += other.stat;
  }
};

Totals totals_of(const PackageReport& package) {
  Totals totals;
  for (const Site& site : package.report.sites) {
    if (site.kind == SiteKind::advertise || site.level == Level::not_needed) continue;
    const bool ported = site.level != Level::plain;
    const bool publishes = site.kind == SiteKind::publish;
    ++(publishes ? totals.publish : totals.subscribe);
    (publishes ? totals.published_in_memory : totals.read_in_memory) += ported;
  }
  totals.left = static_cast<unsigned>(
      std::count_if(package.report.sites.begin(), package.report.sites.end(), is_refusal));
  totals.copies = sum_of(estimates(package));
  totals.stat = package.stat();
  return totals;
}

std::string meta(const std::string& name, const std::string& value) {
  return value.empty() ? "" : fmt::format("<dt>{}</dt><dd>{}</dd>", name, value);
}

std::string commits(const RunReport& run) {
  std::string text;
  for (const PackageReport& package : run) {
    const std::string one = "<code>" + html_escaped(package.commit) + "</code>";
    if (!package.commit.empty() && text.find(one) == std::string::npos)
      text += (text.empty() ? "" : ", ") + one;
  }
  return text;
}

std::string header(const RunReport& run, const RunInfo& info) {
  const std::string title =
      run.size() == 1 ? html_escaped(run[0].report.package) : std::to_string(run.size()) + " packages";
  return fmt::format(
      "<header>\n<h1>TZC port of {}</h1>\n<dl class=\"meta\">{}{}{}{}</dl>\n</header>\n", title,
      meta("made", html_escaped(info.date)),
      meta("by", info.version.empty() ? "" : "tzc-rewrite " + html_escaped(info.version)),
      meta("commit", commits(run)),
      meta("command", info.command.empty() ? "" : "<code>" + html_escaped(info.command) + "</code>"));
}

std::string cells(const Totals& totals) {
  return fmt::format(
      "<td class=\"num\">{} of {}</td><td class=\"num\">{} of {}</td><td class=\"num {}\">{}</td><td "
      "class=\"num\">{} &rarr; {}</td><td class=\"num\">{}</td><td class=\"num\"><span "
      "class=\"good\">+{}</span> "
      "<span class=\"bad\">&minus;{}</span></td>",
      totals.published_in_memory, totals.publish, totals.read_in_memory, totals.subscribe,
      totals.left == 0 ? "good" : "bad", totals.left, totals.copies.before, totals.copies.after,
      totals.stat.files, totals.stat.added, totals.stat.removed);
}

/// The packages with links to their sections, and their sum.
std::string contents(const RunReport& run) {
  if (run.size() < 2) return "";
  std::string html =
      "<nav>\n<h2>Packages</h2>\n<table class=\"sites contents\"><thead><tr><th>package</th><th "
      "class=\"num\">published in "
      "shared memory</th><th class=\"num\">read there</th><th class=\"num\">sites left</th><th "
      "class=\"num\">copies per "
      "message, now and after</th><th class=\"num\">changed files</th><th "
      "class=\"num\">lines</th></tr></thead>\n<tbody>\n";
  Totals all;
  for (const PackageReport& package : run) {
    const Totals totals = totals_of(package);
    all.add(totals);
    html += fmt::format("<tr><td><a href=\"#{0}\">{0}</a></td>{1}</tr>\n",
                        html_escaped(package.report.package), cells(totals));
  }
  return html + "</tbody>\n<tfoot><tr><td>together</td>" + cells(all) + "</tr></tfoot></table>\n</nav>\n";
}

}  // namespace

std::string to_html(const RunReport& run, const RunInfo& info) {
  std::string title, body;
  for (const PackageReport& package : run) {
    title += (title.empty() ? "" : ", ") + package.report.package;
    body += html_package(package);
  }
  return valid_utf8(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>TZC port of " +
      html_escaped(title) + "</title>\n<style>" + html_style + "</style>\n</head>\n<body>\n" +
      header(run, info) + contents(run) + html_filters + body + "<script type=\"text/javascript\">" +
      html_script + "</script>\n</body>\n</html>\n");
}

}  // namespace tzc::rewriter
