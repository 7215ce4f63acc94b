// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "options.h"
#include "paper/cell.h"

namespace tzc {
namespace bench {

/// One measurement that is to be made. `cell` is that of the CellResult.
struct Turn {
  const Cell* cell;
  std::size_t round;
  std::size_t count;
};

/// What the results lack, the cells taking turns.
std::vector<Turn> turns_of(const Options& options, const std::vector<CellResult>& results);

/// How long measurements take: a cell's messages as long as those that were measured of it, or as the rate says where
/// there are none; starting and ending processes as long as in this run so far.
class Timetable {
 public:
  Timetable(double rate, const std::vector<CellResult>& results);

  /// A measurement took so many seconds in all.
  void add(const Turn& turn, const Measurement& round, double seconds);
  double seconds_of(const Turn& turn) const;
  /// Of those from this one on.
  double seconds_from(std::size_t first, const std::vector<Turn>& turns) const;

 private:
  double messages_s(const Turn& turn) const;

  const double period_s_;
  std::map<const Cell*, double> period_of_s_;  // of cells that were measured
  double around_s_ = 0;                        // summed over the measurements of this run
  std::size_t measured_ = 0;
};

/// "1 minute", "3 h 20 min".
std::string duration_text(double seconds);

/// "1 case", "2 cases".
std::string counted(std::size_t number, const char* noun);

}  // namespace bench
}  // namespace tzc
