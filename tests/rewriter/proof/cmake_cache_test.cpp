// SPDX-License-Identifier: BSD-3-Clause
#include "proof/cmake_cache.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "support/temp_dir.h"

namespace tzc::rewriter {
namespace {

using tzc::test::TempDir;

TEST(CmakeCache, entries_and_values) {
  const CmakeCache cache("/b",
                         "# c\n//doc\nA:BOOL=ON\n\"B:X\":STRING=a=b;c\nC_DIR:PATH=C_DIR-NOTFOUND\n"
                         "A-ADVANCED:INTERNAL=1\n");
  ASSERT_EQ(cache.entries().size(), 4u);
  EXPECT_EQ(cache.entries()[0].type, "BOOL");
  EXPECT_EQ(cache.value("A"), "ON");
  EXPECT_EQ(cache.value("B:X"), "a=b;c");
  EXPECT_EQ(cache.value("C_DIR"), "");
  EXPECT_EQ(cache.value("D"), "");
}

TEST(CmakeCache, the_nearest_one_above_a_folder) {
  const TempDir folder;
  folder.write("build/CMakeCache.txt", "A:BOOL=ON\n");
  folder.write("build/sub/x", "");
  EXPECT_EQ(CmakeCache::nearest(folder / "build/sub").folder(), folder / "build");
  EXPECT_TRUE(CmakeCache::nearest(folder.path()).empty());
}

TEST(CmakeCache, a_command_sets_the_value_as_it_is) {
  EXPECT_EQ(cache_command({"A", "STRING", "${X} \"q\" \\"}),
            "set(A [[${X} \"q\" \\]] CACHE STRING \"\" FORCE)\n");
  EXPECT_EQ(cache_command({"A", "UNINITIALIZED", "x]]y"}), "set(A [=[x]]y]=] CACHE STRING \"\" FORCE)\n");
}

}  // namespace
}  // namespace tzc::rewriter
