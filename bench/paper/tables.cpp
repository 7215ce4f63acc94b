// SPDX-License-Identifier: BSD-3-Clause
#include "paper/tables.h"

#include <fmt/format.h>

#include "paper/store.h"

namespace tzc {
namespace bench {
namespace {

using nlohmann::json;

std::string number(double value) {
  return fmt::format("{:.3f}", value);
}

Fields key_of(const Cell& cell) {
  return {cell.contender, std::to_string(cell.size_bytes), std::to_string(cell.subscribers)};
}

void append(Fields& row, std::initializer_list<double> values) {
  for (const double value : values) row.push_back(number(value));
}

std::string quoted(const std::string& field) {
  if (field.find_first_of(",\"\n\r") == std::string::npos) return field;
  std::string text = "\"";
  for (const char c : field) text += c == '"' ? "\"\"" : std::string(1, c);
  return text + "\"";
}

std::string line_of(const Fields& row) {
  std::string line;
  for (const std::string& field : row) line += quoted(field) + ",";
  line.back() = '\n';
  return line;
}

json to_json(const Spread& spread) {
  return {{"count", spread.count}, {"min", spread.least},     {"p1", spread.p1},
          {"q1", spread.q1},       {"median", spread.median}, {"q3", spread.q3},
          {"p99", spread.p99},     {"max", spread.most},      {"mean", spread.mean}};
}

}  // namespace

Table latency_table(const std::vector<Summary>& summaries) {
  Table table{{"contender", "size_bytes", "subscribers", "rate_hz", "holds_rate", "delivered_share", "min_us",
               "p1_us", "q1_us", "median_us", "q3_us", "p99_us", "max_us", "mean_us"},
              {}};
  for (const Summary& summary : summaries) {
    Fields row = key_of(summary.cell);
    row.push_back(number(summary.rate));
    row.emplace_back(summary.holds_rate ? "yes" : "no");
    row.push_back(fmt::format("{:.6f}", mean_share(summary)));
    if (const auto& us = summary.latency_us)
      append(row, {us->least, us->p1, us->q1, us->median, us->q3, us->p99, us->most, us->mean});
    row.resize(table.columns.size());
    table.rows.push_back(row);
  }
  return table;
}

Table reliability_table(const std::vector<Summary>& summaries) {
  Table table{{"contender", "size_bytes", "subscribers", "subscriber", "sent", "delivered", "share"}, {}};
  for (const Summary& summary : summaries) {
    for (std::size_t who = 0; who < summary.delivered.size(); ++who) {
      Fields row = key_of(summary.cell);
      row.push_back(std::to_string(who));
      row.push_back(std::to_string(summary.sent));
      row.push_back(std::to_string(summary.delivered[who]));
      const auto share = static_cast<double>(summary.delivered[who]) / static_cast<double>(summary.sent);
      row.push_back(fmt::format("{:.6f}", share));
      table.rows.push_back(row);
    }
  }
  return table;
}

Table copies_table(const std::vector<Summary>& summaries) {
  Table table{{"contender", "size_bytes", "subscribers", "copies", "publisher_copied_bytes",
               "publisher_sent_bytes", "publisher_page_faults", "subscribers_received_bytes",
               "subscribers_copied_bytes", "subscribers_page_faults"},
              {}};
  for (const Summary& summary : summaries) {
    const Cost &publisher = summary.publisher, &subscribers = summary.subscribers;
    Fields row = key_of(summary.cell);
    row.push_back(number(copies_per_message(summary)));
    for (const std::uint64_t total :
         {publisher.copied_bytes, publisher.sent_bytes, publisher.page_faults, subscribers.received_bytes,
          subscribers.copied_bytes, subscribers.page_faults})
      row.push_back(number(static_cast<double>(total) / static_cast<double>(summary.sent)));
    table.rows.push_back(row);
  }
  return table;
}

std::string to_csv(const Table& table) {
  std::string text = line_of(table.columns);
  for (const Fields& row : table.rows) text += line_of(row);
  return text;
}

json to_json(const CellResult& result, const Summary& summary) {
  json document{{"contender", summary.cell.contender},
                {"size_bytes", summary.cell.size_bytes},
                {"subscribers", summary.cell.subscribers},
                {"under_load", summary.cell.conditions.load},
                {"real_time", summary.cell.conditions.real_time},
                {"rate_hz", summary.rate},
                {"holds_rate", summary.holds_rate},
                {"sent", summary.sent},
                {"delivered", summary.delivered},
                {"latency_us", summary.latency_us ? to_json(*summary.latency_us) : json()},
                {"copies", copies_per_message(summary)},
                {"rounds", json::array()}};
  for (const auto& [ignored, round] : result.rounds) document["rounds"].push_back(to_json(round));
  return document;
}

}  // namespace bench
}  // namespace tzc
