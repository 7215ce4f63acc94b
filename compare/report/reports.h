// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "report/result.h"

namespace tzc::compare {

/// The result for people.
std::string text_report(const Result& result);

/// The result for programs; the keys are described in docs/tzc-compare.md.
nlohmann::json json_report(const Result& result);

}  // namespace tzc::compare
