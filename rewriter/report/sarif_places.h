// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "report/output.h"

namespace tzc::rewriter {

/// Names places in SARIF: relative to the root of their package's sources, where they lie below it.
class SarifPlaces {
 public:
  explicit SarifPlaces(const RunReport& run);

  nlohmann::ordered_json artifact(const PackageReport& package, const std::string& file) const;
  nlohmann::ordered_json location(const PackageReport& package, const Location& where) const;

  /// originalUriBaseIds
  nlohmann::ordered_json bases() const;

 private:
  std::vector<std::string> roots_;  ///< in the order of the packages, each once
};

}  // namespace tzc::rewriter
