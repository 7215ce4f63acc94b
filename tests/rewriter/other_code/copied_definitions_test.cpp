// SPDX-License-Identifier: BSD-3-Clause
// Definitions that another package of the workspace holds, too.
#include "other_code/copied_definitions.h"

#include <gtest/gtest.h>

#include "edits/files.h"
#include "support/temp_dir.h"

namespace tzc::rewriter {
namespace {

class CopiedDefinitions : public ::testing::Test {
 protected:
  CopiedDefinitions() {
    package("demo", "demo");
    folder.write("ws/src/demo/include/demo/holder.h",
                 "#pragma once\nstruct Own { int a; };\n// Holds.\nstruct Holder {\n  int b;\n};\n");
  }
  void package(const std::string& place, const std::string& name) const {
    folder.write("ws/src/" + place + "/package.xml",
                 "<package format=\"2\"><name>" + name + "</name></package>");
  }
  std::vector<CopiedDefinition> copied() const {
    return copied_definitions(canonical_path(folder / "ws/src/demo"), folder / "ws/src");
  }

  const std::string copy = "struct Holder { int b; };  // from demo\n";
  tzc::test::TempDir folder;
};

TEST_F(CopiedDefinitions, are_found_whatever_else_the_headers_hold) {
  package("other", "other");
  folder.write("ws/src/other/src/holder.h", copy + "struct Mine { int c; };\n");
  const auto found = copied();
  ASSERT_EQ(found.size(), 1u);
  const std::string header = folder.read("ws/src/demo/include/demo/holder.h");
  EXPECT_EQ(found[0].file, canonical_path(folder / "ws/src/demo/include/demo/holder.h"));
  EXPECT_LE(found[0].begin, header.find("struct Holder"));
  EXPECT_GT(found[0].end, header.find("int b"));
  EXPECT_GT(found[0].begin, header.find("int a"));
  EXPECT_EQ(found[0].copy, canonical_path(folder / "ws/src/other/src/holder.h"));
}

TEST_F(CopiedDefinitions, another_definition_of_that_name_is_none) {
  package("other", "other");
  folder.write("ws/src/other/src/holder.h", "struct Holder { long b; };\n");
  EXPECT_TRUE(copied().empty());
}

TEST_F(CopiedDefinitions, another_checkout_and_what_is_not_built_are_none) {
  package("old/demo", "demo");
  folder.write("ws/src/old/demo/include/demo/holder.h", copy);
  package("ignored", "ignored");
  folder.write("ws/src/ignored/CATKIN_IGNORE", "");
  folder.write("ws/src/ignored/holder.h", copy);
  folder.write("ws/src/unowned/holder.h", copy);
  EXPECT_TRUE(copied().empty());
}

}  // namespace
}  // namespace tzc::rewriter
