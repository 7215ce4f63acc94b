// SPDX-License-Identifier: BSD-3-Clause
#include "paper/plan.h"

#include <fmt/format.h>

#include <algorithm>

#include "paper/turns.h"

namespace tzc {
namespace bench {
namespace {

/// One line of the plan.
struct Part {
  std::string name;
  std::size_t cells = 0, measurements = 0, memory_bytes = 0;
  double seconds = 0;

  void add(const Part& other) {
    cells += other.cells;
    measurements += other.measurements;
    memory_bytes = std::max(memory_bytes, other.memory_bytes);  // measurements come one after the other
    seconds += other.seconds;
  }
};

std::string name_of(const Cell& cell) {
  return cell.contender + (cell.conditions.real_time ? ", real time" : "") +
         (cell.conditions.load ? ", under load" : "");
}

Part& part_of(std::vector<Part>& parts, const std::string& name) {
  const auto found =
      std::find_if(parts.begin(), parts.end(), [&](const Part& part) { return part.name == name; });
  if (found != parts.end()) return *found;
  parts.push_back({name});
  return parts.back();
}

std::string line_of(const Part& part) {
  return fmt::format("{:32} {:>6} {:>13} {:>14} {:>9}\n", part.name, part.cells, part.measurements,
                     part.measurements > 0 ? duration_text(part.seconds) : "-", size_text(part.memory_bytes));
}

}  // namespace

std::string plan_text(const Options& options, const std::vector<CellResult>& results,
                      const MemoryOf& memory_of) {
  const Timetable timetable(options.rate, results);
  std::vector<Part> parts;
  for (const CellResult& result : results)
    part_of(parts, name_of(result.cell)).add({"", 1, 0, memory_of(result.cell), 0});
  for (const Turn& turn : turns_of(options, results))
    part_of(parts, name_of(*turn.cell)).add({"", 0, 1, 0, timetable.seconds_of(turn)});
  Part all{"all"};
  std::string text =
      fmt::format("{:32} {:>6} {:>13} {:>14} {:>9}\n", "", "cases", "measurements", "time", "memory");
  for (const Part& part : parts) {
    text += line_of(part);
    all.add(part);
  }
  return text + line_of(all);
}

}  // namespace bench
}  // namespace tzc
