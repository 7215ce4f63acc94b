// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <time.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "port/cache_inputs.h"

namespace tzc::rewriter {

/// The result of a run over the packages of one build tree, from an earlier run for which everything was the same.
/// docs/rewriter.md has the argument why a hit is right.
class PortCache {
 public:
  PortCache(const std::vector<std::string>& packages, const PortInputs& inputs);

  /// None: there is no such run, or something that it has read is different now.
  std::optional<std::vector<PackagePort>> find() const;

  /// To be called before the analysis, which tells it what it reads; null: nothing will be kept.
  FileAccesses* record();

  /// Keeps a result, unless what it depends on cannot be told, or has changed since this object was made.
  void keep(const std::vector<PackagePort>& ports);

 private:
  using States = std::map<FileAccesses::Entry, std::string>;
  std::string key() const;
  bool is_own_scratch(const std::string& path) const;
  States states(const std::set<FileAccesses::Entry>& places) const;
  bool is_any_changed(const std::set<FileAccesses::Entry>& places) const;

  timespec start_{};
  const PortOptions& options_;
  Digest digest_;
  bool is_used_ = false;
  CacheInputs inputs_;
  std::string key_, scratch_prefix_;
  States states_before_;  ///< of what is known before the analysis
  FileAccesses accesses_;
};

}  // namespace tzc::rewriter
