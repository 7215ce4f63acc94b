// SPDX-License-Identifier: BSD-3-Clause
#include <exception>
#include <iostream>

#include "engine/digest.h"
#include "engine/engine.h"
#include "format/format.h"
#include "tool/run.h"

int main(int argc, char** argv) {
  try {
    return tzc::rewriter::tool_main(
        argc, argv, {tzc::rewriter::plan_ports, tzc::rewriter::format_changes, tzc::rewriter::blake3_digest});
  } catch (const std::exception& defect) {
    std::cerr << "tzc-rewrite: " << defect.what()
              << "\n  this is a defect of tzc-rewrite, please report it\n";
    return 2;
  }
}
