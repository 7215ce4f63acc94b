// SPDX-License-Identifier: BSD-3-Clause
#include "paper/page.h"

#include <fmt/format.h>

#include "paper/comparison.h"
#include "paper/tables.h"

namespace tzc {
namespace bench {
namespace {

using nlohmann::json;

constexpr char head[] = R"(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<title>TZC evaluation</title>
<style>
body { font: 16px/1.5 sans-serif; max-width: 1150px; margin: 2em auto; padding: 0 1em; color: #222; }
table { border-collapse: collapse; font-size: 14px; margin: 1em 0; }
th, td { padding: 2px 10px; border-bottom: 1px solid #ddd; text-align: right; }
th { background: #f4f4f4; position: sticky; top: 0; }
th:first-child, td:first-child { text-align: left; }
figure { margin: 1em 0; overflow-x: auto; }
figcaption, .note { color: #555; font-size: 14px; }
.bad { background: #fde8e0; }
</style>
</head>
<body>
<h1>TZC evaluation</h1>
)";

constexpr char measuring[] =
    R"(<p>One publisher sends at a fixed rate to subscribers that are processes of their own, except for <code>intraprocess</code>.
The contenders take turns in rounds. Each measurement begins with 20 messages that do not count.</p>
)";

constexpr char publishing_span[] =
    R"(<p>The span begins right before the publisher calls publish and ends where the subscriber's callback begins. Inside are
what publish does (serialization, the copy into a ring or into datagrams), the way, and what comes before the callback
(de-serialization, the copy out, a callback queue). Outside are allocating or borrowing the message and filling it:
contenders that copy send the same buffer again, the others get a message each time, before the span; none writes new
content, and no callback reads the content.</p>
)";

constexpr char filling_span[] =
    R"(<p>The span begins before the publisher allocates or borrows the message, and ends where the
subscriber's callback begins. Inside are allocating, writing every byte of the message anew, publishing, the way, and what
comes before the callback. No callback reads the content.</p>
)";

constexpr char overview_text[] =
    "<p>Each contender over all its cells: how many it sent at the rate, the smallest share of messages that "
    "a "
    "subscriber got, the largest median and 99th percentile in µs, and the median of 4 MB divided by "
    "that "
    "of 4 KB, for the number of subscribers where that is most.</p>\n";

constexpr char ranking_text[] =
    "<p>Medians in µs, the fastest first. * not every message was delivered, or the publisher did not "
    "reach 95&nbsp;% of the rate.</p>\n";

constexpr char latency_text[] =
    "<p>Times in µs. Box: first to third quartile; line: median; whiskers: 1st to 99th percentile, of "
    "all deliveries. * "
    "not every "
    "message was delivered, or the publisher did not reach 95&nbsp;% of the rate: the figures are of what "
    "arrived.</p>\n";

constexpr char reliability_text[] =
    "<p>Deliveries of each subscriber. A message counts as lost when it has not come after a second in which "
    "none "
    "came.</p>\n";

constexpr char copies_text[] =
    "<p>Of one message, all processes together, counted while the messages of the latency table were sent: "
    "bytes through "
    "the libc's memcpy and memmove (calls of 1 KB or more), send, sendto and sendmsg, recv, recvfrom and "
    "recvmsg; the "
    "kernel's count of page faults. copies: these bytes divided by the message's. Zero-filling is no "
    "copy.</p>\n";

constexpr char load_text[] =
    "<p>Every processor is busy with another process of normal priority that computes and moves "
    "memory.</p>\n";

constexpr char real_time_text[] =
    "<p>Publisher and subscribers scheduled by SCHED_FIFO, with memory that is locked and in place; with and "
    "without a "
    "process of normal priority that keeps each processor busy. <code>futex</code>: the bare wake-up of one "
    "process by "
    "another, without a message. least_delivered_share: of the messages, to the subscriber that got fewest. "
    "Error of the period: how far the time between two deliveries is from that "
    "of the rate. "
    "Allocations (calls of malloc and its like) and page faults are of one message, all processes "
    "together.</p>\n";

constexpr char types_text[] =
    "<p>A type needs support when its definition has an array of variable length, at any depth. It is "
    "supported when one "
    "of them is a data part: an array of fixed-length elements, which lies in shared memory.</p>\n";

constexpr char effort_text[] =
    "<p>What <code>tzc-rewrite</code> changes in a package, build files included, as counted in its diff. "
    "Nobody writes "
    "these lines; the paper reports fewer than 100 written by hand for each package.</p>\n";

constexpr std::size_t most_rows_of_markdown = 30;  // more is read in a file

std::string text_of(const json& value) {
  return value.is_string() ? value.get<std::string>() : value.dump();
}

std::string definitions(const json& object) {
  std::string text = "<table>\n";
  for (const auto& [name, value] : object.items())
    text += fmt::format("<tr><td>{}</td><td>{}</td></tr>\n", escaped(name), escaped(text_of(value)));
  return text + "</table>\n";
}

std::string row(const char* element, const std::vector<std::string>& fields, bool bad) {
  std::string text = bad ? "<tr class=\"bad\">" : "<tr>";
  for (const std::string& field : fields) text += fmt::format("<{0}>{1}</{0}>", element, escaped(field));
  return text + "</tr>\n";
}

std::string html(const Section& section) {
  std::string text = "<table>\n" + row("th", section.table.columns, false);
  for (const auto& fields : section.table.rows)
    text += row("td", fields, section.is_bad != nullptr && section.is_bad(fields));
  return text + "</table>\n";
}

bool lacks_rate(const std::vector<std::string>& fields) {
  return fields[4] == "no";
}

bool lost_some(const std::vector<std::string>& fields) {
  return fields[4] != fields[5];
}

// An SVG file begins with an XML declaration, which has no place inside of a page.
std::string inline_svg(const std::string& document) {
  const std::size_t begin = document.find("<svg");
  return begin == std::string::npos ? "" : document.substr(begin);
}

std::string figures(const std::vector<Plot>& plots) {
  std::string text;
  for (const Plot& plot : plots) text += fmt::format("<figure>\n{}</figure>\n", inline_svg(plot.svg));
  return text;
}

std::string span_of(const json& run) {
  const std::string span = run.value("/settings/span"_json_pointer, "publish");
  return std::string(measuring) + (span == "publish" ? publishing_span : filling_span);
}

std::string markdown_row(const std::vector<std::string>& fields) {
  std::string text = "|";
  for (const std::string& field : fields) text += " " + escaped(field) + " |";
  return text + "\n";
}

std::string markdown(const Table& table) {
  std::string text = markdown_row(table.columns) + "|";
  for (std::size_t i = 0; i < table.columns.size(); ++i) text += " --- |";
  text += "\n";
  for (const auto& fields : table.rows) text += markdown_row(fields);
  return text;
}

std::string markdown(const Section& section) {
  std::string text = fmt::format("## {}\n\n{}\n", section.heading, section.text);
  for (const Plot& plot : section.plots) text += fmt::format("![{0}]({0}.svg)\n\n", plot.name);
  if (section.table.rows.size() <= most_rows_of_markdown) text += markdown(section.table) + "\n";
  return text + fmt::format("[{0}]({0}): {1} rows.\n\n", section.file, section.table.rows.size());
}

std::string markdown_list(const json& object) {
  std::string text;
  for (const auto& [name, value] : object.items())
    text += fmt::format("- {}: {}\n", escaped(name), escaped(text_of(value)));
  return text;
}

}  // namespace

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

std::vector<Section> usual_sections(const std::vector<Summary>& summaries, std::vector<Plot> plots) {
  return {{"Overview", overview_text, "overview.csv", {}, overview_table(summaries)},
          {"Ranking", ranking_text, "ranking.csv", {}, ranking_table(summaries)},
          {"Latency", latency_text, "latency.csv", std::move(plots), latency_table(summaries), lacks_rate},
          {"Reliability", reliability_text, "reliability.csv", {}, reliability_table(summaries), lost_some},
          {"Copies", copies_text, "copies.csv", {}, copies_table(summaries)}};
}

std::vector<Section> load_sections(const std::vector<Summary>& summaries, std::vector<Plot> plots) {
  const std::string busy = load_text;
  return {{"Under load: overview", busy + overview_text, "overview-load.csv", {}, overview_table(summaries)},
          {"Under load: latency", busy + latency_text, "latency-load.csv", std::move(plots),
           latency_table(summaries), lacks_rate},
          {"Under load: reliability",
           busy + reliability_text,
           "reliability-load.csv",
           {},
           reliability_table(summaries),
           lost_some}};
}

Section real_time_section(const std::vector<RealTimeFigures>& figures, std::vector<Plot> plots) {
  return {"Real time", real_time_text, "real-time.csv", std::move(plots), real_time_table(figures)};
}

Section types_section(Table table) {
  return {"Message types", types_text, "types.csv", {}, std::move(table)};
}

Section effort_section(Table table) {
  return {"Effort", effort_text, "effort.csv", {}, std::move(table)};
}

std::string page_of(const json& run, const std::vector<Section>& sections) {
  std::string text = head + definitions(run.at("machine")) + definitions(run.at("versions")) +
                     definitions(run.at("settings")) +
                     fmt::format("<p>Begun {}.</p>\n", escaped(text_of(run.at("begun")))) +
                     "<h2>What is measured</h2>\n" + span_of(run);
  for (const Section& section : sections)
    if (!section.table.rows.empty())
      text += "<h2>" + section.heading + "</h2>\n" + section.text + figures(section.plots) + html(section);
  return text + "</body>\n</html>\n";
}

std::string markdown_of(const json& run, const std::vector<Section>& sections) {
  std::string text = "# Figures of the evaluation\n\nWritten by `tzc-bench paper`, begun " +
                     escaped(text_of(run.at("begun"))) + ". The machine, versions and settings:\n\n" +
                     markdown_list(run.at("machine")) + markdown_list(run.at("versions")) +
                     markdown_list(run.at("settings")) + "\n" + span_of(run) + "\n";
  for (const Section& section : sections)
    if (!section.table.rows.empty()) text += markdown(section);
  return text;
}

}  // namespace bench
}  // namespace tzc
