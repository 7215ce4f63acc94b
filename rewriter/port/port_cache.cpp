// SPDX-License-Identifier: BSD-3-Clause
#include "port/port_cache.h"

#include <algorithm>
#include <atomic>
#include <filesystem>

#include "cache/result_store.h"
#include "edits/files.h"
#include "edits/in_parallel.h"
#include "port/port_record.h"

namespace tzc::rewriter {
namespace {

constexpr const char* format = "tzc-rewrite results 2\n";

}  // namespace

PortCache::PortCache(const std::vector<std::string>& packages, const PortInputs& inputs)
    : options_(inputs.options), digest_(inputs.engine.digest) {
  is_used_ = digest_ && !options_.cache_dir.empty();
  if (!is_used_) return;
  std::error_code failed;
  const std::filesystem::path temporary = std::filesystem::temp_directory_path(failed);
  scratch_prefix_ = canonical_path(temporary) + "/tzc-rewrite-";
  inputs_ = cache_inputs(packages, inputs);
  is_used_ = inputs_.complete;
  if (is_used_) key_ = key();
}

std::string PortCache::key() const {
  std::string text = format + inputs_.settings;
  const PathStates states(digest_, inputs_.omitted);
  for (const std::string& tree : inputs_.trees) text += tree + "\n" + states.of(tree, Access::tree) + "\n";
  return text;
}

std::optional<std::vector<PackagePort>> PortCache::find() const {
  if (!is_used_) return {};
  const std::optional<std::string> bytes = ResultStore(options_.cache_dir, digest_).find(key_);
  if (!bytes) return {};
  std::optional<PortRecord> record = decoded(*bytes);
  if (!record) return {};
  std::vector<std::pair<FileAccesses::Entry, std::string>> places(record->places.begin(),
                                                                  record->places.end());
  const PathStates states(digest_);
  std::atomic<bool> same{true};
  in_parallel(options_.jobs, places.size(), [&](std::size_t i) {
    const auto& [place, state] = places[i];
    if (same && states.of(place.first, place.second) != state) same = false;
  });
  if (!same) return {};
  return std::move(record->ports);
}

/// Folders that this run has made; what is in them follows from the rest.
bool PortCache::is_own_scratch(const std::string& path) const {
  return path.rfind(scratch_prefix_, 0) == 0;
}

PortCache::States PortCache::states(const std::set<FileAccesses::Entry>& places) const {
  std::vector<FileAccesses::Entry> list;
  for (const FileAccesses::Entry& place : places)
    if (!is_own_scratch(place.first)) list.push_back(place);
  std::vector<std::string> texts(list.size());
  const PathStates now(digest_);
  in_parallel(options_.jobs, list.size(),
              [&](std::size_t i) { texts[i] = now.of(list[i].first, list[i].second); });
  States states;
  for (std::size_t i = 0; i < list.size(); ++i) states[list[i]] = texts[i];
  return states;
}

bool PortCache::is_any_changed(const std::set<FileAccesses::Entry>& places) const {
  ChangesSince changes(start_);
  return std::any_of(places.begin(), places.end(), [&](const FileAccesses::Entry& place) {
    return !is_own_scratch(place.first) && changes.concern(place.first, place.second);
  });
}

FileAccesses* PortCache::record() {
  if (!is_used_) return nullptr;
  states_before_ = states(inputs_.places);
  ::clock_gettime(CLOCK_REALTIME_COARSE, &start_);  // the clock of file times
  return &accesses_;
}

void PortCache::keep(const std::vector<PackagePort>& ports) {
  if (!is_used_ || !accesses_.is_complete() || key() != key_) return;
  States all = states(accesses_.entries());
  if (is_any_changed(accesses_.entries()) || states(inputs_.places) != states_before_) return;
  all.insert(states_before_.begin(), states_before_.end());
  ResultStore(options_.cache_dir, digest_).keep(key_, encoded({all, ports}));
}

}  // namespace tzc::rewriter
