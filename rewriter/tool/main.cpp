// SPDX-License-Identifier: BSD-3-Clause
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <exception>
#include <iostream>
#include <system_error>

#include "engine/digest.h"
#include "engine/engine.h"
#include "format/format.h"
#include "interruption/interruption.h"
#include "tool/run.h"

int main(int argc, char** argv) {
  tzc::rewriter::handle_interruptions(
      "tzc-rewrite: interrupted; what it says to have written is written, everything else is as it was");
  try {
    const int status = tzc::rewriter::tool_main(
        argc, argv, {tzc::rewriter::plan_ports, tzc::rewriter::format_changes, tzc::rewriter::blake3_digest});
    std::cout.flush();
    const bool written = std::fflush(stdout) == 0 && std::ferror(stdout) == 0 && std::cout;
    if (written || status != 0) return status;  // a run that could not write its report has said so
    std::cerr << "tzc-rewrite: cannot write to standard output: " << std::strerror(errno) << '\n';
    return 2;
  } catch (const std::system_error& error) {
    std::cerr << "tzc-rewrite: " << error.what() << '\n';
    return 2;
  } catch (const std::exception& defect) {
    std::cerr << "tzc-rewrite: " << defect.what()
              << "\n  this is a defect of tzc-rewrite, please report it\n";
    return 2;
  }
}
