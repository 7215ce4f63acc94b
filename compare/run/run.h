// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

namespace tzc::compare {

/// The nodes and input of a run, the same for every workspace.
struct Input {
  std::vector<std::string> launches;  ///< arguments of roslaunch
  std::vector<std::string> commands;  ///< for bash -c
  std::string bag;                    ///< played once all nodes are there; empty: none
  std::vector<std::string> play_arguments;
  bool simulates_time = false;  ///< use_sim_time, and the bag's clock
  double duration_s = 10;       ///< of a run without a bag that does not end by itself
  double settle_s = 2;          ///< the graph must be unchanged for so long before the bag is played
  double quiet_s = 2;           ///< after the bag a run ends when nothing was published for so long
  double start_timeout_s = 60;
};

struct Recorded {
  std::vector<std::string> topics, excluded;  ///< regular expressions
  bool over_tcpros = false;
};

/// The results of one run.
struct Run {
  std::string bag;
  nlohmann::json summary;                     ///< the recorder's
  std::vector<nlohmann::json> statistics;     ///< TZC's counters of each topic and process
  std::map<std::string, double> cpu_seconds;  ///< by node
  double seconds = 0;                         ///< that the processor time was measured for
  std::set<std::string> failures;             ///< nodes that died, and commands that failed
  bool ended_by_itself = false;               ///< nothing more would have come
};

/// Receives a line of progress; short-lived ones replace each other.
using Progress = std::function<void(const std::string&)>;

/// Runs the input in a workspace under a roscore of its own and records what its nodes publish. Every process
/// that it starts has stopped when it returns or throws.
/// @param folder gets the recording and the logs; must exist
/// @throws Failure, Stopped
Run run_workspace(const std::string& workspace, const std::string& folder, const Input& input,
                  const Recorded& recorded, const Progress& progress);

}  // namespace tzc::compare
