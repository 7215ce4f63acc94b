// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "run/child.h"

namespace tzc::compare {

/// tzc-compare-recorder as a child.
class RecorderProcess {
 public:
  /// @param arguments its options
  RecorderProcess(const std::vector<std::string>& arguments, const Environment& environment,
                  const std::string& log_file);

  /// Its last status, after at most `wait_ms` for a new one. @throws Failure when it has ended or cannot
  /// write
  const nlohmann::json& status(int wait_ms);
  /// Its present counts of topics, connections and input. @throws Failure
  nlohmann::json summary();
  /// Ends the recording; the bag is complete then. @throws Failure
  void finish();

 private:
  using Clock = std::chrono::steady_clock;

  void read(int wait_ms);
  [[noreturn]] void fail();

  Child child_;
  std::string text_;  ///< an incomplete line
  nlohmann::json status_, summary_;
  Clock::time_point heard_;  ///< when it said something last
};

}  // namespace tzc::compare
