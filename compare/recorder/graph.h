// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <set>
#include <string>

namespace tzc::compare {

/// What the master knows, without the recorder itself and without rosout.
struct Graph {
  std::map<std::string, std::set<std::string>> publishers;   ///< topic -> nodes
  std::map<std::string, std::set<std::string>> subscribers;  ///< topic -> nodes
  std::map<std::string, std::string> types;                  ///< topic -> datatype

  std::set<std::string> nodes() const;
  /// Differs when anything else differs.
  std::string fingerprint() const;
};

/// Asks the master. False: it does not answer; the graph is as it was.
bool read_graph(Graph& graph);

}  // namespace tzc::compare
