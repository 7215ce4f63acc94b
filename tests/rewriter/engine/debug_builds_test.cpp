// SPDX-License-Identifier: BSD-3-Clause
#include "engine/debug_builds.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace tzc::rewriter {
namespace {

bool has_debug_build(std::vector<std::string> options) {
  CompileUnit unit{"/p/node.cpp", "/p", {"c++"}};
  for (std::string& option : options) unit.arguments.push_back(std::move(option));
  return debug_build_of(unit).has_value();
}

TEST(DebugBuilds, are_those_of_units_that_are_compiled_with_ndebug) {
  EXPECT_TRUE(has_debug_build({"-O2", "-DNDEBUG"}));
  EXPECT_TRUE(has_debug_build({"-D", "NDEBUG"}));
  EXPECT_TRUE(has_debug_build({"-DNDEBUG=1"}));
  EXPECT_FALSE(has_debug_build({"-O2"}));
  EXPECT_FALSE(has_debug_build({"-DNDEBUG_LEVEL=1", "-I", "NDEBUG"}));
}

TEST(DebugBuilds, the_last_option_counts) {
  EXPECT_FALSE(has_debug_build({"-DNDEBUG", "-UNDEBUG"}));
  EXPECT_FALSE(has_debug_build({"-DNDEBUG", "-U", "NDEBUG"}));
  EXPECT_TRUE(has_debug_build({"-UNDEBUG", "-DNDEBUG"}));
}

TEST(DebugBuilds, differ_in_that_alone) {
  const CompileUnit unit{"/p/node.cpp", "/p", {"c++", "-DNDEBUG", "-O2"}};
  const auto build = debug_build_of(unit);
  ASSERT_TRUE(build);
  EXPECT_EQ(build->file, unit.file);
  EXPECT_EQ(build->arguments, (std::vector<std::string>{"c++", "-DNDEBUG", "-O2", "-UNDEBUG"}));
  EXPECT_FALSE(debug_build_of(*build));
}

}  // namespace
}  // namespace tzc::rewriter
