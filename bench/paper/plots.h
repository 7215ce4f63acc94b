// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "paper/cell.h"
#include "paper/store.h"

namespace tzc {
namespace bench {

/// "5.4 patchlevel 4"; empty when gnuplot is not installed.
std::string gnuplot_version();

/// gnuplot's input that draws box plots of all cells with so many subscribers: sizes along x, latency on a logarithmic
/// axis, a colour for each contender. The output is plot_name.svg.tmp and plot_name.png.tmp in the working folder.
std::string plot_script(const std::vector<Summary>& summaries, std::size_t subscribers);
/// "latency-4": the plot's file name without its ending.
std::string plot_name(std::size_t subscribers);

/// Writes the plot's script, SVG and PNG into the store. Throws StoreError with what gnuplot said.
void draw(const Store& store, const std::vector<Summary>& summaries, std::size_t subscribers);

}  // namespace bench
}  // namespace tzc
