// SPDX-License-Identifier: BSD-3-Clause
#include "edits/standard_flags.h"

#include <gtest/gtest.h>

namespace tzc::rewriter {
namespace {

TEST(StandardFlags, before_cxx14_are_raised_to_it) {
  EXPECT_EQ(raised_standard("-std=c++98"), "-std=c++14");
  EXPECT_EQ(raised_standard("-std=gnu++0x"), "-std=gnu++14");
  EXPECT_EQ(raised_standard("-std=gnu++11"), "-std=gnu++14");
}

TEST(StandardFlags, may_have_two_dashes) {
  EXPECT_EQ(raised_standard("--std=c++11"), "--std=c++14");
  EXPECT_TRUE(is_standard_flag("--std=c++17"));
}

TEST(StandardFlags, others_stay) {
  for (const char* flag :
       {"-std=c++14", "--std=c++17", "-std=c++2a", "-std=", "-DSTD=c++11", "-O2", "---std=c++11", ""})
    EXPECT_EQ(raised_standard(flag), flag);
}

TEST(StandardFlags, of_cxx98_and_what_was_to_become_cxx11) {
  for (const char* flag : {"-std=c++98", "-std=gnu++03", "--std=c++0x"})
    EXPECT_TRUE(is_before_cxx11(flag)) << flag;
  for (const char* flag : {"-std=c++11", "-std=gnu++14", ""}) EXPECT_FALSE(is_before_cxx11(flag)) << flag;
}

}  // namespace
}  // namespace tzc::rewriter
