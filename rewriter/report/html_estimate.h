// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "report/output.h"

namespace tzc::rewriter {

/// What the port of a package buys, and what is left, as a table of its publish sites; empty: it publishes no data.
std::string html_estimate(const PackageReport& package);

/// "1 copy", "4 copies".
std::string copies(unsigned n);

}  // namespace tzc::rewriter
