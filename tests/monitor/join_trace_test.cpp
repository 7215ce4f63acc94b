// SPDX-License-Identifier: BSD-3-Clause
#include "join_trace.h"

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

namespace tzc::monitor {
namespace {

struct JoinTrace : testing::Test {
  void add(const std::string& name, const std::string& text) {
    std::istringstream file(text);
    EXPECT_TRUE(join.add(file, name));
  }

  std::ostringstream out;
  TraceJoin join{out};
};

TEST_F(JoinTrace, of_whole_files_is_one_array) {
  add("a", "[\n{\"pid\":1},\n{\"pid\":1}\n]\n");
  add("b", "[\n{\"pid\":2}\n]\n");
  EXPECT_TRUE(join.finish());
  EXPECT_EQ(nlohmann::json::parse(out.str()).size(), 3U);
  EXPECT_TRUE(join.troubles().empty());
}

TEST_F(JoinTrace, leaves_out_the_line_that_a_killed_process_did_not_finish) {
  add("a", "[\n{\"pid\":1},\n{\"pid\":1,\"na");
  add("b", "[\n{\"pid\":2},\n");
  EXPECT_TRUE(join.finish());
  EXPECT_EQ(nlohmann::json::parse(out.str()).size(), 2U);
  ASSERT_EQ(join.troubles().size(), 1U);
  EXPECT_NE(join.troubles()[0].find("a: 1 lines"), std::string::npos);
}

TEST_F(JoinTrace, of_files_that_are_no_traces_is_a_failure_and_writes_nothing) {
  add("picture.png", "\x89PNG\n");
  add("empty", "");
  EXPECT_FALSE(join.finish());
  EXPECT_EQ(out.str(), "");
  EXPECT_EQ(join.troubles().size(), 2U);
}

TEST_F(JoinTrace, of_what_cannot_be_read_says_so) {
  std::ifstream folder("/");
  EXPECT_FALSE(join.add(folder, "/"));
  ASSERT_EQ(join.troubles().size(), 1U);
  EXPECT_EQ(join.troubles()[0], "/ cannot be read");
}

}  // namespace
}  // namespace tzc::monitor
