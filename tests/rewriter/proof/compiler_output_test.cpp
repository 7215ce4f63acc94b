// SPDX-License-Identifier: BSD-3-Clause
#include "proof/compiler_output.h"

#include <gtest/gtest.h>

namespace tzc::rewriter {
namespace {

TEST(CompilerOutput, of_gcc) {
  const auto errors = read_compiler_output(
      "In file included from /p/a.cpp:1:\n"
      "/p/a.h: In instantiation of 'void fill(T&) [with T = int]':\n"
      "/p/a.cpp:7:7:   required from here\n"
      "/p/a.h:3:21: error: request for member 'data' in 't', which is of non-class type 'int'\n"
      "    3 |   t.data;\n"
      "/p/a.h:2:6: note: declared here\n"
      "/p/a.cpp:9:1: warning: unused variable 'x' [-Wunused-variable]\n"
      "/p/a.cpp:8:1: note: of the warning\n"
      "/p/a.cpp:9:5: error: unused variable 'y' [-Werror=unused-variable]\n"
      "cc1plus: some warnings being treated as errors\n");
  ASSERT_EQ(errors.size(), 2u);
  EXPECT_EQ(errors[0].where.file, "/p/a.h");
  EXPECT_EQ(errors[0].where.line, 3u);
  EXPECT_EQ(errors[0].where.column, 21u);
  EXPECT_EQ(errors[0].text, "request for member 'data' in 't', which is of non-class type 'int'");
  ASSERT_EQ(errors[0].notes.size(), 2u);
  EXPECT_EQ(errors[0].notes[0].line, 7u);
  EXPECT_EQ(errors[0].notes[1].line, 2u);
  EXPECT_EQ(errors[1].where.line, 9u);
  EXPECT_TRUE(errors[1].notes.empty());
}

TEST(CompilerOutput, of_clang_and_without_a_column) {
  const auto errors =
      read_compiler_output("a.cpp:3:1: fatal error: 'x.h' file not found\nb.cpp:4: error: no\n");
  ASSERT_EQ(errors.size(), 2u);
  EXPECT_EQ(errors[0].text, "'x.h' file not found");
  EXPECT_EQ(errors[1].where.line, 4u);
  EXPECT_EQ(errors[1].where.column, 0u);
}

TEST(CompilerOutput, what_names_no_place_is_no_error) {
  EXPECT_TRUE(
      read_compiler_output("g++: error: unrecognized option\nninja: error: x\n\n:3: error: y\n").empty());
}

}  // namespace
}  // namespace tzc::rewriter
