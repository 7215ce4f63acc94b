// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <set>
#include <string>
#include <vector>

#include "paper/cell.h"
#include "paper/store.h"

namespace tzc {
namespace bench {

/// "5.4 patchlevel 4"; empty when gnuplot is not installed.
std::string gnuplot_version();

/// The contenders' colours, in their order; they begin again after the last one.
const char* colour_at(std::size_t contender);

/// gnuplot's lines that draw `plot` into NAME.svg.tmp and NAME.png.tmp.
std::string outputs(const std::string& name, const std::string& plot);

/// gnuplot's input that draws box plots of all cells with so many subscribers, measured under the same conditions: sizes along x, latency on a logarithmic
/// axis, a colour for each contender. The output is plot_name.svg.tmp and plot_name.png.tmp in the working folder.
std::string plot_script(const std::vector<Summary>& summaries, std::size_t subscribers);
/// "latency-4", "latency-4-load": the plot's file name without its ending.
std::string plot_name(std::size_t subscribers, const Conditions& conditions);

/// Writes NAME.gnuplot, NAME.svg and NAME.png into the store; the SVG document. Nothing for an empty script. Throws
/// StoreError with what gnuplot said, or where it has not written all.
std::string draw(const Store& store, const std::string& name, const std::string& script);

/// Removes the plots of earlier runs from the store, but for these names: they do not show what its tables have.
void remove_plots_but(const std::set<std::string>& drawn, const Store& store);

}  // namespace bench
}  // namespace tzc
