// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "tool/workspace.h"

namespace tzc::rewriter::test {

/// Runs the program on a Workspace.
class Cli : public ::testing::Test {
 protected:
  bool is_ported() const { return ws.file("src/node.cpp").find("tzc::Publisher") != std::string::npos; }
  /// A site that stays plain.
  nlohmann::json refusal() const {
    return {{"id", "publish:src/node.cpp:main:1"}, {"line", 3}, {"level", "plain"}, {"code", "TZC1001"}};
  }
  Workspace ws;
};

}  // namespace tzc::rewriter::test
