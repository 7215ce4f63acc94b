// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "paper/cell.h"

namespace tzc {
namespace bench {

/// A file that cannot be read or written, or says what it should not; what() is for the user.
struct StoreError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The output folder of an evaluation. A file in it is whole, or is not there: it is written beside its place and
/// then renamed. For one thread. While one Store has a folder, another one throws StoreError, in other processes, too.
class Store {
 public:
  /// Makes the folder, with what lies above it, and removes what a killed process left half written.
  explicit Store(std::string folder);
  ~Store();
  Store(const Store&) = delete;
  Store& operator=(const Store&) = delete;

  std::string path_of(const std::string& name) const { return folder_ + "/" + name; }
  void write(const std::string& name, const std::string& content) const;
  std::string read(const std::string& name) const;
  bool has(const std::string& name) const;
  /// Takes a file that another program wrote as NAME.tmp.
  void take(const std::string& name) const;
  /// Removes NAME.tmp, if it is there.
  void discard(const std::string& name) const;
  /// Removes NAME, if it is there.
  void remove(const std::string& name) const;

  /// Whether a run has begun in the folder, which need not be there.
  static bool has_begun(const std::string& folder);
  /// Writes run.json, or compares it with an earlier one: "settings", "machine" and "versions" must be the same,
  /// so that the results are of one kind.
  void begin(const nlohmann::json& run) const;

  /// The cells of which something was measured already, by this run or an earlier one; in no order.
  std::vector<Cell> cells() const;
  /// The rounds of the cell that were measured already.
  CellResult load(const Cell& cell) const;
  std::vector<CellResult> load(const std::vector<Cell>& cells) const;
  void save(const CellResult& result) const;

 private:
  std::string folder_;
  int lock_;  // the folder's descriptor; children that are forked have it too, so it lasts as long as they do
};

/// Without the cell. latency_ns has null for what was not delivered.
nlohmann::json to_json(const Measurement& round);
Measurement round_of_json(const nlohmann::json& json);

}  // namespace bench
}  // namespace tzc
