// SPDX-License-Identifier: BSD-3-Clause
#include "paper/turns.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace tzc {
namespace bench {
namespace {

constexpr double usual_around_s = 2;  // starting, ending and resting, before any measurement has told
constexpr double warm_up_messages = 20;

/// Seconds from one message to the next while the cell was measured; 0: it was not.
double measured_period(const CellResult& result) {
  double seconds = 0;
  std::size_t messages = 0;
  for (const auto& [number, round] : result.rounds) {
    seconds += round.seconds;
    messages += round.latency_ns.front().size();
  }
  return messages > 0 ? seconds / static_cast<double>(messages) : 0;
}

}  // namespace

// A virtual machine's wake-ups can take twice as long in one minute as in the next: taking turns gives every cell its
// share of both.
std::vector<Turn> turns_of(const Options& options, const std::vector<CellResult>& results) {
  std::vector<Turn> turns;
  for (std::size_t round = 0; round < options.rounds; ++round) {
    const std::size_t count = share_of(options, round);
    for (const CellResult& result : results)
      if (count > 0 && result.rounds.count(round) == 0) turns.push_back({&result.cell, round, count});
  }
  return turns;
}

Timetable::Timetable(double rate, const std::vector<CellResult>& results) : period_s_(1 / rate) {
  for (const CellResult& result : results)
    if (const double period = measured_period(result); period > 0) period_of_s_[&result.cell] = period;
}

void Timetable::add(const Turn& turn, const Measurement& round, double seconds) {
  period_of_s_[turn.cell] = round.seconds / static_cast<double>(turn.count);
  around_s_ += std::max(0.0, seconds - messages_s(turn));
  ++measured_;
}

double Timetable::messages_s(const Turn& turn) const {
  const auto known = period_of_s_.find(turn.cell);
  return (warm_up_messages + static_cast<double>(turn.count)) *
         (known != period_of_s_.end() ? known->second : period_s_);
}

double Timetable::seconds_of(const Turn& turn) const {
  return messages_s(turn) + (measured_ > 0 ? around_s_ / static_cast<double>(measured_) : usual_around_s);
}

double Timetable::seconds_from(std::size_t first, const std::vector<Turn>& turns) const {
  double seconds = 0;
  for (std::size_t i = first; i < turns.size(); ++i) seconds += seconds_of(turns[i]);
  return seconds;
}

std::string duration_text(double seconds) {
  const auto minutes = std::max<std::size_t>(1, static_cast<std::size_t>(std::ceil(seconds / 60)));
  return minutes < 60 ? counted(minutes, "minute")
                      : fmt::format("{} h {:02} min", minutes / 60, minutes % 60);
}

std::string counted(std::size_t number, const char* noun) {
  return fmt::format("{} {}{}", number, noun, number == 1 ? "" : "s");
}

}  // namespace bench
}  // namespace tzc
