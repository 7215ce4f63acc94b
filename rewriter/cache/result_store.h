// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "cache/path_state.h"

namespace tzc::rewriter {

/// A folder of results by key. Runs may use it at the same time and be killed at any moment: an entry appears whole,
/// under a name of its own until then, and one that is damaged is no entry. No failure of the folder is an error.
class ResultStore {
 public:
  /// `folder` empty: keeps nothing and has nothing.
  ResultStore(std::string folder, Digest digest, std::uint64_t most_bytes = 256u << 20)
      : folder_(std::move(folder)), digest_(std::move(digest)), most_bytes_(most_bytes) {}

  /// The key is compared as a whole, so no two keys share an entry.
  std::optional<std::string> find(const std::string& key) const;

  /// Then removes the entries that were used least recently, until the rest has no more than `most_bytes`.
  void keep(const std::string& key, const std::string& result) const;

 private:
  std::string entry_of(const std::string& key) const;
  void shrink() const;

  std::string folder_;
  Digest digest_;
  std::uint64_t most_bytes_;
};

}  // namespace tzc::rewriter
