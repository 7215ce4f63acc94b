// SPDX-License-Identifier: BSD-3-Clause
#include "support/golden_case.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/temp_dir.h"

namespace tzc::test {
namespace {

using ::testing::ElementsAre;
using ::testing::Pair;

/// A case on disk, and the switch as a test wants it.
class GoldenCaseTest : public ::testing::Test {
 protected:
  void TearDown() override {
    if (before_.empty())
      ::unsetenv("TZC_UPDATE_GOLDEN");
    else
      ::setenv("TZC_UPDATE_GOLDEN", before_.c_str(), 1);
  }

  static std::string environment() {
    const char* value = std::getenv("TZC_UPDATE_GOLDEN");
    return value ? value : "";
  }

  void update(const char* value) { ::setenv("TZC_UPDATE_GOLDEN", value, 1); }
  GoldenCase read(const std::string& text) { return GoldenCase(folder_.write("one.case", text)); }

  const std::string before_ = environment();
  TempDir folder_;
};

TEST_F(GoldenCaseTest, has_a_head_sections_and_an_expectation) {
  const GoldenCase one = read("head\n//--- a.h\nint a;\n#--- uses\n//--- expected\n// out\n");
  EXPECT_EQ(one.head(), "head\n");
  EXPECT_THAT(one.sections(), ElementsAre(Pair("a.h", "int a;\n"), Pair("uses", "")));
  EXPECT_EQ(one.section("a.h"), "int a;\n");
  EXPECT_EQ(one.section("none"), "");
  EXPECT_EQ(one.expected(), "// out\n");
}
TEST_F(GoldenCaseTest, without_an_expectation_is_an_error) {
  EXPECT_THROW(read("head\n"), std::runtime_error);
  EXPECT_THROW(read("head\n//===\n// out\n"), std::runtime_error);
  EXPECT_THROW(read("head\n//--- expected\n// out\n//--- a.h\n"), std::runtime_error);
  EXPECT_THROW(GoldenCase(folder_ / "missing.case"), std::runtime_error);
}
TEST_F(GoldenCaseTest, is_compared_when_the_switch_is_off) {
  update("0");
  EXPECT_EQ(read("head\n#--- expected\nold\n").expected("new\n"), "old\n");
  EXPECT_EQ(folder_.read("one.case"), "head\n#--- expected\nold\n");
}
TEST_F(GoldenCaseTest, is_written_when_the_switch_is_on) {
  update("1");
  EXPECT_EQ(read("head\n//--- a\nx\n#--- expected\nold\n").expected("new\n"), "new\n");
  EXPECT_EQ(folder_.read("one.case"), "head\n//--- a\nx\n#--- expected\nnew\n");
}
TEST_F(GoldenCaseTest, whole_files_obey_the_same_switch) {
  const std::string path = folder_.write("report.txt", "old");
  update("0");
  EXPECT_EQ(golden_file(path, "new"), "old");
  update("1");
  EXPECT_EQ(golden_file(path, "new"), "new");
  EXPECT_EQ(folder_.read("report.txt"), "new");
}
TEST_F(GoldenCaseTest, are_found_below_a_folder_and_named_by_their_path) {
  const std::string b = folder_.write("plain/b-c.cpp", ""), a = folder_.write("a.cpp", "");
  folder_.write("a.txt", "");
  EXPECT_THAT(GoldenCase::all(folder_.path(), ".cpp"), ElementsAre(a, b));
  EXPECT_EQ(GoldenCase::test_name(folder_.path(), b), "plain_b_c");
}

}  // namespace
}  // namespace tzc::test
