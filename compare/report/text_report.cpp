// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "report/reports.h"

namespace tzc::compare {
namespace {

using Row = std::vector<std::string>;

/// Rows with aligned columns, the first one as a heading.
std::string table(const std::vector<Row>& rows) {
  std::vector<std::size_t> widths(rows.front().size());
  for (const Row& row : rows)
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  std::string text;
  for (const Row& row : rows) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) line += fmt::format("{:<{}}", row[i], widths[i] + 2);
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + "\n";
  }
  return text + "\n";
}

/// The differences between the original's own runs, in few words: "header.stamp, loss".
std::string own_differences(const StreamVerdict& verdict) {
  std::vector<std::string> words;
  for (const Finding& found : verdict.findings)
    words.emplace_back(found.cause == Cause::content ? found.field : name(found.cause));
  return fmt::format("{}", fmt::join(words, ", "));
}

std::string outcome_words(const StreamVerdict& verdict) {
  switch (verdict.outcome) {
    case Outcome::equal:
      return "equal";
    case Outcome::own_differences:
      return "equal but for " + own_differences(verdict);
    case Outcome::silent:
      return "nothing published";
    case Outcome::different:
      return "DIFFERENT";
  }
  return "";
}

std::string topic_table(const Result& result) {
  std::vector<Row> rows{{"topic", "node", "original", "port", "pairs", "paired by", ""}};
  for (const StreamVerdict& verdict : result.verdicts) {
    const StreamComparison& compared = verdict.comparison;
    const std::size_t pairs = compared.pairing.pairs.size();
    rows.push_back({compared.topic, compared.publisher, fmt::to_string(compared.first.messages),
                    fmt::to_string(compared.second.messages), fmt::to_string(pairs),
                    pairs == 0 ? "-" : name(compared.pairing.by), outcome_words(verdict)});
  }
  return table(rows);
}

std::string share(const Finding& found) {
  return fmt::format("{} of {} messages", found.count, found.total);
}

std::string finding_words(const Finding& found) {
  switch (found.cause) {
    case Cause::not_published:
      return "not advertised by the port";
    case Cause::new_topic:
      return "advertised by the port only";
    case Cause::type:
      return "type: " + found.detail;
    case Cause::loss:
      return "loss: the port lacks " + share(found) + (found.detail.empty() ? "" : "; " + found.detail);
    case Cause::extra:
      return "extra: the port has " + share(found) + " that the original lacks" +
             (found.detail.empty() ? "" : "; " + found.detail);
    case Cause::order:
      return "order: " + share(found) + " come in another order";
    case Cause::content:
      break;
  }
  return fmt::format("content: {} differs in {}; {}", found.field.empty() ? "the bytes" : found.field,
                     share(found), found.detail);
}

std::string own_words(const Finding& found) {
  if (found.own_share == 0) return found.is_different ? "" : " (allowed)";
  const std::string own = fmt::format(" (between the original's own runs: {:.0f} %)", found.own_share * 100);
  return found.is_different ? own + ", more than that" : own;
}

std::string findings(const Result& result, bool is_different) {
  std::string text;
  for (const StreamVerdict& verdict : result.verdicts) {
    std::string lines;
    for (const Finding& found : verdict.findings)
      if (found.is_different == is_different)
        lines += fmt::format("  {}{}\n", finding_words(found), own_words(found));
    if (!lines.empty())
      text += fmt::format("{} from {}\n{}", verdict.comparison.topic, verdict.comparison.publisher, lines);
  }
  if (text.empty()) return "";
  return (is_different ? "Different\n\n"
                       : "No difference, because the original's own runs differ there, too\n\n") +
         text + "\n";
}

std::string failures(const Result& result) {
  std::string text;
  for (const std::string& failure : result.port_failures)
    text += fmt::format("DIED, in the port only: {}\n", failure);
  for (const std::string& failure : result.own_failures)
    text += fmt::format("Died in the original: {}\n", failure);
  return text.empty() ? "" : text + "\n";
}

/// Messages at the ends of a run that has no defined beginning or end.
std::string ends(const Result& result) {
  std::size_t before = 0, after = 0;
  for (const StreamVerdict& verdict : result.verdicts) {
    const Pairing& pairing = verdict.comparison.pairing;
    before += pairing.first_only.before.size() + pairing.second_only.before.size();
    after += pairing.first_only.after.size() + pairing.second_only.after.size();
  }
  std::string text;
  if (before != 0 && !result.judges_before)
    text += fmt::format(
        "Not judged: {} messages from before the other recording began (no bag starts the input)\n", before);
  if (after != 0 && !result.judges_after)
    text += fmt::format(
        "Not judged: {} messages from after the other recording ended (the run was cut off)\n", after);
  if (!result.omissions.late_topics.empty() && result.judges_before)
    text +=
        fmt::format("Not judged: the first messages of topics that are advertised after the bag began: {}\n",
                    fmt::join(result.omissions.late_topics, ", "));
  return text.empty() ? "" : text + "\n";
}

std::string latency_table(const Result& result) {
  std::vector<Row> rows{
      {"latency to the recorder, us", "node", "original median", "p99", "port median", "p99"}};
  const auto cells = [](const Resources& used, const std::pair<std::string, std::string>& key) {
    const auto found = used.latency.find(key);
    if (found == used.latency.end()) return Row{"-", "-"};
    return Row{fmt::format("{:.0f}", found->second.median_us), fmt::format("{:.0f}", found->second.p99_us)};
  };
  for (const auto& [key, latency] : result.original_resources.latency) {
    Row row{key.first, key.second};
    for (const Resources* used : {&result.original_resources, &result.port_resources})
      for (std::string& cell : cells(*used, key)) row.push_back(std::move(cell));
    rows.push_back(row);
  }
  return rows.size() == 1 ? "" : table(rows);
}

std::string cpu_table(const Result& result) {
  std::vector<Row> rows{{"processor time", "original", "port"}};
  std::set<std::string> nodes;
  for (const Resources* used : {&result.original_resources, &result.port_resources})
    for (const auto& [node, seconds] : used->cpu_seconds) nodes.insert(node);
  const auto cell = [](const Resources& used, const std::string& node) {
    const auto found = used.cpu_seconds.find(node);
    if (found == used.cpu_seconds.end() || used.seconds <= 0) return std::string("-");
    return fmt::format("{:.2f} s ({:.0f} %)", found->second, 100 * found->second / used.seconds);
  };
  for (const std::string& node : nodes)
    rows.push_back({node, cell(result.original_resources, node), cell(result.port_resources, node)});
  return rows.size() == 1 ? "" : table(rows);
}

Row copies_cells(const Resources& used, const std::string& topic) {
  const auto found = used.copies.find(topic);
  if (found == used.copies.end() || found->second.messages == 0) return {"-", "-"};
  const Copies& copies = found->second;
  return {fmt::format("{:.0f}", copies.bytes_per_delivery()),
          fmt::format("{} of {}", copies.shared, copies.connections)};
}

std::string copied(const Resources& used, const std::string& topic) {
  const auto found = used.copies.find(topic);
  if (found == used.copies.end() || !found->second.copied_bytes || found->second.published.value_or(0) == 0)
    return "-";
  return fmt::format("{}", *found->second.copied_bytes / *found->second.published);
}

std::string copies_table(const Result& result) {
  std::vector<Row> rows{{"bytes through sockets per delivery", "original", "shared", "port", "shared",
                         "copied into shared memory per message"}};
  for (const auto& [topic, copies] : result.original_resources.copies) {
    Row row{topic};
    for (const Resources* used : {&result.original_resources, &result.port_resources})
      for (std::string& cell : copies_cells(*used, topic)) row.push_back(std::move(cell));
    row.push_back(copied(result.port_resources, topic));
    rows.push_back(row);
  }
  return rows.size() == 1 ? "" : table(rows);
}

std::string conclusion(const Result& result) {
  const auto count = [&](Outcome outcome) {
    return std::count_if(result.verdicts.begin(), result.verdicts.end(),
                         [&](const StreamVerdict& verdict) { return verdict.outcome == outcome; });
  };
  const auto different = count(Outcome::different), own = count(Outcome::own_differences);
  std::string text = fmt::format("EQUAL: {} topics\n", result.verdicts.size());
  if (result.is_different())
    text = fmt::format("DIFFERENT: {} of {} topics{}\n", different, result.verdicts.size(),
                       result.port_failures.empty() ? "" : ", and a node died");
  if (own != 0)
    text += fmt::format("{} of them but for what differs between the original's own runs, too\n", own);
  if (!result.omissions.topics.empty())
    text += fmt::format("{} topics were left out: {}\n", result.omissions.topics.size(),
                        fmt::join(result.omissions.topics, ", "));
  for (const std::string& field : result.omissions.unknown_fields)
    text += fmt::format(
        "--ignore '{}' left nothing out: no topic's messages have such a field (an array's name ends in "
        "[])\n",
        field);
  return text;
}

}  // namespace

std::string text_report(const Result& result) {
  return fmt::format("original  {} ({} runs)\nport      {}\n\n", result.original, result.original_runs,
                     result.port) +
         topic_table(result) + failures(result) + findings(result, true) + findings(result, false) +
         ends(result) + latency_table(result) + cpu_table(result) + copies_table(result) + conclusion(result);
}

}  // namespace tzc::compare
