// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>

#include "report/sarif_places.h"

namespace tzc::rewriter {

/// `fixes` of a result: the port of its whole package, since a part of it need not compile.
nlohmann::ordered_json sarif_fixes(const PackageReport& package, const SarifPlaces& places);

/// Bytes of SARIF up to which each pending place of a package carries the fix. Beyond, only the first one does: the
/// file would grow with the square of the package.
constexpr std::size_t largest_fixes = 4u << 20;

}  // namespace tzc::rewriter
