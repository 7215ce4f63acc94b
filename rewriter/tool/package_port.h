// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <map>
#include <string>

#include "edits/files.h"
#include "engine.h"
#include "report/output.h"
#include "tool/options.h"

namespace tzc::rewriter {

/// The parts that know Clang, as the tool sees them; tests put others in their place.
struct Engine {
  std::function<Expected<PortPlan>(const EngineOptions&)> plan;
  /// Formats the changed lines of a source: (path, before, after) to text. May be empty.
  std::function<std::string(const std::string&, const std::string&, const std::string&)> format;
};

/// One package, planned: what to write and what to report. Nothing is written yet.
struct PackagePort {
  std::string package_dir;
  FileContents contents;  ///< absolute path -> new content
  Snapshot before;        ///< what was analysed
  PackageReport result;
};

struct PortInputs {
  const Options& options;
  const Engine& engine;
  const std::map<std::string, std::uint64_t>& measured_sizes;
  Progress* progress = nullptr;
};

/// Analyses a package, sources and build files.
Expected<PackagePort> port_package(const std::string& package_dir, const PortInputs& inputs);

}  // namespace tzc::rewriter
