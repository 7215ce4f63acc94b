// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>

#include "engine/options.h"
#include "engine/port_plan.h"
#include "model/expected.h"
#include "other_code/unseen_files.h"
#include "port/port_options.h"

namespace tzc::rewriter {

/// The parts that use Clang, as functions; tests replace them.
struct Engine {
  std::function<Expected<PortPlans>(const EngineOptions&)> plan;
  /// Formats the changed lines of a source: (path, before, after) to text. May be empty.
  std::function<std::string(const std::string&, const std::string&, const std::string&)> format;
  /// Tells texts apart, for the cache; see Digest. Empty: no cache.
  std::function<std::string(std::string_view)> digest;
};

struct PortInputs {
  const PortOptions& options;
  const Engine& engine;
  const std::map<std::string, std::uint64_t>& measured_sizes;
  IncludeGraphs& graphs;
  Progress* progress = nullptr;
  FileAccesses* accesses = nullptr;  ///< told what the result depends on; null: it is not kept
};

}  // namespace tzc::rewriter
