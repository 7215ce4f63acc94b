// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "edits/files.h"
#include "engine/engine.h"
#include "report/output.h"
#include "tool/options.h"

namespace tzc::rewriter {

/// The parts that use Clang, as functions; tests replace them.
struct Engine {
  std::function<Expected<PortPlan>(const EngineOptions&)> plan;
  /// Formats the changed lines of a source: (path, before, after) to text. May be empty.
  std::function<std::string(const std::string&, const std::string&, const std::string&)> format;
  /// Tells texts apart, for the cache; see Digest. Empty: no cache.
  std::function<std::string(std::string_view)> digest;
};

/// One package, planned: what to write and what to report. Nothing is written yet.
struct PackagePort {
  std::string package_dir;
  FileContents contents;  ///< absolute path -> new content
  Snapshot before;        ///< what was analysed
  PackageReport result;
  std::string build_dir;        ///< holds compile_commands.json
  std::set<std::string> units;  ///< main files that must see TZC
  std::vector<Note> hints;      ///< build file edits that the user must make
  bool refused = false;         ///< its build files were not proved: nothing of it is changed
};

struct PortInputs {
  const Options& options;
  const Engine& engine;
  const std::map<std::string, std::uint64_t>& measured_sizes;
  Progress* progress = nullptr;
  FileAccesses* accesses = nullptr;  ///< told what the result depends on; null: it is not kept
};

/// Analyses a package, sources and build files.
Expected<PackagePort> port_package(const std::string& package_dir, const PortInputs& inputs);

}  // namespace tzc::rewriter
