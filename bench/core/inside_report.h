// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace tzc {
namespace bench {

/// Runs the benchmarks of this program, prints Google Benchmark's table and writes the rows to the file of
/// --json: a benchmark is a contender, median and p99 are those of its repetitions. The exit code.
int run_and_report(int argc, char** argv);

}  // namespace bench
}  // namespace tzc
