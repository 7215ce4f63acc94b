// SPDX-License-Identifier: BSD-3-Clause
#include "paper/paper_cells.h"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "paper/contender_table.h"
#include "posix/memory_limit.h"
#include "real_time.h"

namespace tzc {
namespace bench {
namespace {

constexpr std::size_t largest_in_real_time = 4 << 20;
constexpr std::size_t kept_free = std::size_t{256} << 20;

void add(std::vector<Cell>& cells, const Options& options, const Contenders& contenders,
         Conditions conditions) {
  for (const auto& [contender, setup] : wanted_cells(options, contenders))
    cells.push_back({contender->name(), setup.size_bytes, setup.subscribers, conditions});
}

/// One case: the largest message of those that are wanted, up to 4 MB, for the most subscribers.
Options in_real_time_case(Options options) {
  auto& sizes = options.sizes;
  const auto too_large = [](std::size_t size) { return size > largest_in_real_time; };
  sizes.erase(std::remove_if(sizes.begin(), sizes.end(), too_large), sizes.end());
  if (!sizes.empty()) sizes = {*std::max_element(sizes.begin(), sizes.end())};
  options.subscribers = {*std::max_element(options.subscribers.begin(), options.subscribers.end())};
  return options;
}

/// Behind the others, where this program has no such contender.
std::size_t place_of(const Cell& cell, const Contestants& contestants) {
  const Contenders& all = cell.conditions.real_time ? contestants.real_time : contestants.usual;
  const auto is_it = [&](const auto& contender) { return contender->name() == cell.contender; };
  return static_cast<std::size_t>(std::find_if(all.begin(), all.end(), is_it) - all.begin());
}

bool is_in_real_time(const Cell& cell) {
  return cell.conditions.real_time;
}

/// Of those that --only names, one that takes part in no usual case; empty: there is none.
std::string only_in_real_time(const PaperOptions& options, const Contestants& contestants) {
  const auto is_usual = [&](const std::string& name) {
    return find_contender(contestants.usual, name) != nullptr;
  };
  return unknown_name(options.cells, is_usual);
}

std::string why_not_in_real_time(const PaperOptions& options, const Contestants& contestants) {
  const auto is_unknown = [&](const std::string& name) {
    return find_contender(contestants.real_time, name) == nullptr;
  };
  const auto& only = options.cells.only;
  if (!only.empty() && std::all_of(only.begin(), only.end(), is_unknown))
    return fmt::format("--real-time: none of the contenders of --only is measured in real time; there are {}",
                       names_of(contestants.real_time));
  return fmt::format(
      "--real-time: only messages up to {} are measured in real time; name a size with --sizes",
      size_text(largest_in_real_time));
}

template <class Condition>
bool remove_cells(std::vector<Cell>& cells, Condition condition) {
  const auto out = std::remove_if(cells.begin(), cells.end(), condition);
  const bool any = out != cells.end();
  cells.erase(out, cells.end());
  return any;
}

}  // namespace

Contender* Contestants::find(const std::string& name) const {
  Contender* found = find_contender(usual, name);
  return found != nullptr ? found : find_contender(real_time, name);
}

std::vector<Cell> cells_of(const PaperOptions& options, const Contestants& contestants) {
  std::vector<Cell> cells;
  add(cells, options.cells, contestants.usual, usual);
  if (options.load) add(cells, options.cells, contestants.usual, under_load);
  if (!options.real_time) return cells;
  const Options one = in_real_time_case(options.cells);
  add(cells, one, contestants.real_time, in_real_time);
  add(cells, one, contestants.real_time, in_real_time_under_load);
  return cells;
}

std::string impossible_wish(const PaperOptions& options, const Contestants& contestants,
                            const std::vector<Cell>& cells) {
  const std::string name = options.real_time ? "" : only_in_real_time(options, contestants);
  if (!name.empty())
    return fmt::format("--only: {} is measured in real time alone: give --real-time, too", name);
  if (options.wants_real_time && std::none_of(cells.begin(), cells.end(), is_in_real_time))
    return why_not_in_real_time(options, contestants);
  return cells.empty() ? nobody_takes_these_sizes : "";
}

void sort(std::vector<Cell>& cells, const Contestants& contestants) {
  const auto key = [&](const Cell& cell) {
    return std::make_tuple(cell.conditions.real_time, cell.conditions.load, cell.size_bytes, cell.subscribers,
                           place_of(cell, contestants), cell.contender);
  };
  std::sort(cells.begin(), cells.end(), [&](const Cell& a, const Cell& b) { return key(a) < key(b); });
}

Setup setup_of(const Cell& cell, const PaperOptions& options) {
  Setup setup{cell.size_bytes, cell.subscribers, options.cells.rate, 0, ""};
  setup.fills = options.fills;
  setup.real_time = cell.conditions.real_time;
  return setup;
}

std::size_t memory_of(const Cell& cell, const PaperOptions& options, const Contestants& contestants) {
  return contestants.find(cell.contender)->memory_bytes(setup_of(cell, options));
}

std::string memory_obstacle(const Cell& cell, const PaperOptions& options, const Contestants& contestants) {
  const std::size_t needed = memory_of(cell, options, contestants), free = posix::memory_headroom();
  if (needed <= free && free - needed >= kept_free) return "";
  return fmt::format("{} of {} to {} subscribers may need {} of memory, and {} is free", cell.contender,
                     size_text(cell.size_bytes), cell.subscribers, size_text(needed), size_text(free));
}

void leave_out_impossible(const PaperOptions& options, const Contestants& contestants,
                          std::vector<Cell>& cells, std::vector<std::string>& said) {
  remove_cells(cells, [&](const Cell& cell) {
    const std::string why = memory_obstacle(cell, options, contestants);
    if (!why.empty()) said.push_back(why + "; left out");
    return !why.empty();
  });
  if (std::none_of(cells.begin(), cells.end(), is_in_real_time)) return;
  const std::string why = real_time_obstacle();
  if (why.empty()) return;
  remove_cells(cells, is_in_real_time);
  said.push_back(why + "; left out: real time");
}

}  // namespace bench
}  // namespace tzc
