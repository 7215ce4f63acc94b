// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// package ──parse──> facts ──solve──> components ──rules──> edits ──verify (demote, again)──> PortPlan
//                                                                                               │
//            report (text, JSON, SARIF, HTML) <── tool ──> diff / staged files, swapped in together

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "edits/edit.h"
#include "report/model.h"

namespace tzc::rewriter {

struct EngineOptions {
  std::string package_dir;             ///< absolute, canonical
  std::string build_dir;               ///< holds compile_commands.json
  Level max_level = Level::zero_copy;  ///< zero_copy, one_copy or plain: how far publishers are ported
  OnExhausted on_exhausted = OnExhausted::deliver;
  std::optional<std::uint64_t> mem_size;                ///< --mem-size: bytes for each publisher
  std::map<std::string, std::uint64_t> measured_sizes;  ///< topic -> largest message of a recording, bytes
  bool dual = false;                                    ///< output that still builds without TZC
  unsigned jobs = 0;                                    ///< 0: one per processor
  std::string tzc_include;                      ///< TZC's own headers and the twins of installed messages
  std::vector<std::string> extra_include_dirs;  ///< generated twins of the package's own messages
  SiteFilter wanted;                            ///< empty: every site
  std::set<std::string> without_rules;          ///< not applied, to show in tests that each is needed; also
                                                ///< "verification", "all-or-nothing", "completeness"
  Progress* progress = nullptr;
};

struct PortPlan {
  Edits edits;  ///< known to compile together
  Report report;
  std::vector<std::string>
      parsed_files;  ///< everything read of the package: hashed against concurrent change
  std::set<std::string> ported_targets_files;  ///< main files whose targets need tzc
  std::set<std::string> needed_headers;        ///< "tzc/ros.h", ...
  std::set<std::string> tzc_types;             ///< "sensor_msgs/Image": twins the ported code uses
};

/// Parses, solves, edits, verifies, demotes. Writes nothing. An error when a file does not parse, or when the
/// report does not hold every call of the package that advertises, publishes or subscribes.
Expected<PortPlan> plan_port(const EngineOptions& options);

}  // namespace tzc::rewriter
