// SPDX-License-Identifier: BSD-3-Clause
#include "paper/real_time_results.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

#include "paper/plots.h"
#include "paper/statistics.h"

namespace tzc {
namespace bench {
namespace {

// Steps of a histogram: so many in each power of ten.
constexpr int steps_of_a_decade = 10;
constexpr double least_us = 0.1;  // what is shorter counts here

/// The time between the deliveries of two messages in succession, of one subscriber.
void add_period_errors(const Measurement& round, std::size_t who, double period_us,
                       std::vector<double>& errors) {
  const auto& latencies = round.latency_ns[who];
  const auto arrival = [&](std::size_t index) {
    return static_cast<double>(round.published_ns[index]) + static_cast<double>(latencies[index]);
  };
  for (std::size_t i = 1; i < latencies.size() && i < round.published_ns.size(); ++i)
    if (latencies[i] != 0 && latencies[i - 1] != 0)
      errors.push_back(std::abs((arrival(i) - arrival(i - 1)) / 1000 - period_us));
}

void add_latencies(const Measurement& round, std::size_t who, RealTimeFigures& figures) {
  for (const std::uint64_t ns : round.latency_ns[who]) {
    if (ns == 0) continue;
    ++figures.delivered[who];
    figures.latencies_us.push_back(static_cast<double>(ns) / 1000);
  }
}

double least_share(const RealTimeFigures& figures) {
  const auto least = std::min_element(figures.delivered.begin(), figures.delivered.end());
  return figures.sent > 0 ? static_cast<double>(*least) / static_cast<double>(figures.sent) : 0;
}

RealTimeFigures figures_of(const CellResult& result, double rate) {
  RealTimeFigures figures;
  figures.cell = result.cell;
  figures.delivered.resize(result.cell.subscribers);
  Cost cost;
  for (const auto& [number, round] : result.rounds) {
    figures.sent += round.latency_ns.front().size();
    cost += round.publisher;
    cost += round.subscribers;
    for (std::size_t who = 0; who < round.latency_ns.size(); ++who) {
      add_latencies(round, who, figures);
      add_period_errors(round, who, 1e6 / rate, figures.period_errors_us);
    }
  }
  std::sort(figures.latencies_us.begin(), figures.latencies_us.end());
  std::sort(figures.period_errors_us.begin(), figures.period_errors_us.end());
  const auto messages = static_cast<double>(std::max<std::size_t>(figures.sent, 1));
  figures.allocations = static_cast<double>(cost.allocations) / messages;
  figures.page_faults = static_cast<double>(cost.page_faults) / messages;
  return figures;
}

void append(std::vector<std::string>& row, const std::vector<double>& sorted,
            std::initializer_list<double> shares) {
  for (const double share : shares)
    row.push_back(sorted.empty() ? "" : fmt::format("{:.3f}", quantile(sorted, share)));
}

std::string label_of(const RealTimeFigures& figures) {
  return figures.cell.contender + (figures.cell.conditions.load ? ", under load" : "");
}

/// How many values fall into each step.
std::string histogram(const std::vector<double>& values) {
  std::map<int, std::size_t> steps;
  for (const double value : values)
    ++steps[static_cast<int>(std::floor(std::log10(std::max(value, least_us)) * steps_of_a_decade))];
  std::string text;
  for (int step = steps.begin()->first - 1; step <= steps.rbegin()->first + 1; ++step) {
    const auto found = steps.find(step);
    // A logarithmic axis has no 0: half a message lies below it.
    text += fmt::format("{:.6g} {}\n", std::pow(10.0, (step + 0.5) / steps_of_a_decade),
                        found != steps.end() ? fmt::format("{}", found->second) : "0.5");
  }
  return text;
}

std::string data(const std::vector<RealTimeFigures>& figures, const char* name,
                 std::vector<double> RealTimeFigures::* values) {
  std::string text;
  for (std::size_t i = 0; i < figures.size(); ++i)
    text += fmt::format("${}{} << END\n{}END\n", name, i, histogram(figures[i].*values));
  return text;
}

std::string curves(const std::vector<RealTimeFigures>& figures, const char* name, bool with_key) {
  std::map<std::string, std::size_t> colour_of;
  std::string text = "plot";
  for (std::size_t i = 0; i < figures.size(); ++i) {
    const std::size_t colour = colour_of.emplace(figures[i].cell.contender, colour_of.size()).first->second;
    text += fmt::format("{} ${}{} using 1:2 with histeps linewidth 1.6 dashtype {} linecolor rgb \"{}\" {}",
                        i > 0 ? "," : "", name, i, figures[i].cell.conditions.load ? 2 : 1, colour_at(colour),
                        with_key ? fmt::format("title \"{}\"", label_of(figures[i])) : "notitle");
  }
  return text + "\n";
}

constexpr char head[] =
    R"(# How many deliveries took how long, and how far the time between two was off the period: steps of a tenth of a decade
set encoding utf8
set logscale xy
set yrange [0.5:*]
set ylabel "deliveries"
set grid xtics ytics linetype 1 linewidth 0.6 linecolor rgb "#cccccc"
set border 3
set xtics nomirror
set ytics nomirror format "%.0f"
set xtics ("100 ns" 0.1, "1 µs" 1, "10 µs" 10, "100 µs" 100, "1 ms" 1000, "10 ms" 1e4, "100 ms" 1e5, "1 s" 1e6)
)";

}  // namespace

std::vector<RealTimeFigures> real_time_figures(const std::vector<CellResult>& results, double rate) {
  std::vector<RealTimeFigures> figures;
  for (const CellResult& result : results)
    if (result.cell.conditions.real_time && !result.rounds.empty())
      figures.push_back(figures_of(result, rate));
  return figures;
}

Table real_time_table(const std::vector<RealTimeFigures>& figures) {
  Table table{{"contender", "size_bytes", "subscribers", "load", "sent", "least_delivered_share", "median_us",
               "p99_us", "p99.9_us", "max_us", "period_error_median_us", "period_error_p99.9_us",
               "period_error_max_us", "allocations", "page_faults"},
              {}};
  for (const RealTimeFigures& one : figures) {
    std::vector<std::string> row{one.cell.contender,
                                 std::to_string(one.cell.size_bytes),
                                 std::to_string(one.cell.subscribers),
                                 one.cell.conditions.load ? "yes" : "no",
                                 std::to_string(one.sent),
                                 fmt::format("{:.6f}", least_share(one))};
    append(row, one.latencies_us, {0.5, 0.99, 0.999, 1});
    append(row, one.period_errors_us, {0.5, 0.999, 1});
    row.push_back(fmt::format("{:.3f}", one.allocations));
    row.push_back(fmt::format("{:.3f}", one.page_faults));
    table.rows.push_back(row);
  }
  return table;
}

std::string real_time_script(const std::vector<RealTimeFigures>& figures) {
  std::vector<RealTimeFigures> shown;
  const auto has_both = [](const RealTimeFigures& one) {
    return !one.latencies_us.empty() && !one.period_errors_us.empty();
  };
  std::copy_if(figures.begin(), figures.end(), std::back_inserter(shown), has_both);
  if (shown.empty()) return "";
  const std::string plots =
      "set multiplot layout 1,2 margins 0.07,0.96,0.14,0.84 spacing 0.1\nset xlabel \"one-way latency\"\n"
      "set key at screen 0.5,0.98 center top horizontal maxrows 2 Left reverse samplen 2\n" +
      curves(shown, "latency", true) + "set xlabel \"error of the period\"\n" +
      curves(shown, "period", false) + "unset multiplot\n";
  return head + data(shown, "latency", &RealTimeFigures::latencies_us) +
         data(shown, "period", &RealTimeFigures::period_errors_us) + outputs("real-time", plots);
}

}  // namespace bench
}  // namespace tzc
