// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "paper/cell.h"

namespace tzc {
namespace bench {

/// One HTML page that refers to nothing outside of itself. `run`: the content of run.json. `plots`: SVG documents.
std::string page_of(const nlohmann::json& run, const std::vector<Summary>& summaries,
                    const std::vector<std::string>& plots);

/// Text as HTML shows it.
std::string escaped(const std::string& text);

}  // namespace bench
}  // namespace tzc
