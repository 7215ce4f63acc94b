// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "paper/cell.h"
#include "paper/real_time_results.h"
#include "paper/tables.h"

namespace tzc {
namespace bench {

/// A section of the page: its heading, a paragraph of HTML, SVG documents and a table.
struct Section {
  std::string heading;
  std::string text;
  std::vector<std::string> plots;
  Table table;
  /// Which rows stand out; null: none.
  bool (*is_bad)(const std::vector<std::string>& fields) = nullptr;
};

/// Of what was measured as usual.
Section latency_section(const std::vector<Summary>& summaries, std::vector<std::string> plots);
Section reliability_section(const std::vector<Summary>& summaries);
Section copies_section(const std::vector<Summary>& summaries);
/// Of what was measured on a busy machine.
Section load_section(const std::vector<Summary>& summaries, std::vector<std::string> plots);
Section real_time_section(const std::vector<RealTimeFigures>& figures, std::vector<std::string> plots);

/// Table II, and the lines that the rewriter changes.
Section types_section(Table table);
Section effort_section(Table table);

/// One HTML page that refers to nothing outside of itself. `run`: the content of run.json. Sections without rows are left
/// out.
std::string page_of(const nlohmann::json& run, const std::vector<Section>& sections);

/// Text as HTML shows it.
std::string escaped(const std::string& text);

}  // namespace bench
}  // namespace tzc
