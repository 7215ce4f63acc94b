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

/// A plot: the name of its files without ending, and its SVG document.
struct Plot {
  std::string name;
  std::string svg;
};

/// A section of the page: its heading, a paragraph of HTML, the name of its table's file, plots and the table.
struct Section {
  std::string heading;
  std::string text;
  std::string file;
  std::vector<Plot> plots;
  Table table;
  /// Which rows stand out; null: none.
  bool (*is_bad)(const std::vector<std::string>& fields) = nullptr;
};

/// Of what was measured as usual: claims and ranking, latency, reliability, copies.
std::vector<Section> usual_sections(const std::vector<Summary>& summaries, std::vector<Plot> plots);
/// Of what was measured on a busy machine.
std::vector<Section> load_sections(const std::vector<Summary>& summaries, std::vector<Plot> plots);
Section real_time_section(const std::vector<RealTimeFigures>& figures, std::vector<Plot> plots);

/// Table II, and the lines that the rewriter changes.
Section types_section(Table table);
Section effort_section(Table table);

/// One HTML page that refers to nothing outside of itself. `run`: the content of run.json. Sections without rows are left
/// out.
std::string page_of(const nlohmann::json& run, const std::vector<Section>& sections);

/// The same in Markdown, for a repository that has the plots' and tables' files beside it. Long tables are links.
std::string markdown_of(const nlohmann::json& run, const std::vector<Section>& sections);

/// Text as HTML shows it.
std::string escaped(const std::string& text);

}  // namespace bench
}  // namespace tzc
