// SPDX-License-Identifier: BSD-3-Clause
#include <exception>
#include <iostream>

#include "engine.h"
#include "format/format.h"
#include "tool/run.h"

int main(int argc, char** argv) {
  try {
    return tzc::rewriter::tool_main(argc, argv, {tzc::rewriter::plan_port, tzc::rewriter::format_changes});
  } catch (const std::exception& defect) {
    std::cerr << "tzc-rewrite: " << defect.what()
              << "\n  this is a defect of tzc-rewrite, please report it\n";
    return 2;
  }
}
