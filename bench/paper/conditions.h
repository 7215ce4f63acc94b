// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace tzc {
namespace bench {

/// Under what conditions a case is measured. The main figures have none of them.
struct Conditions {
  bool load = false;       // every processor is busy with other work: see load.h
  bool real_time = false;  // the processes are scheduled by SCHED_FIFO: see real_time.h

  friend bool operator==(const Conditions& a, const Conditions& b) {
    return a.load == b.load && a.real_time == b.real_time;
  }
};

constexpr Conditions usual{}, under_load{true, false}, in_real_time{false, true},
    in_real_time_under_load{true, true};

/// For names of files: empty, "-load", "-rt" or "-rt-load".
inline std::string suffix_of(const Conditions& conditions) {
  return std::string(conditions.real_time ? "-rt" : "") + (conditions.load ? "-load" : "");
}

}  // namespace bench
}  // namespace tzc
