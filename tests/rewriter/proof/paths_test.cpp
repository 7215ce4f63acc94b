// SPDX-License-Identifier: BSD-3-Clause
#include "proof/paths.h"

#include <gtest/gtest.h>

namespace tzc::rewriter {
namespace {

PathMap demo() {
  PathMap map;
  map.add("/ws/src/demo", "/tmp/s/demo");
  map.except("/ws/src/demo/build");
  return map;
}

TEST(PathMap, a_path_in_every_place_of_a_word) {
  const PathMap map = demo();
  EXPECT_EQ(map.in_word("/ws/src/demo"), "/tmp/s/demo");
  EXPECT_EQ(map.in_word("-I/ws/src/demo/include"), "-I/tmp/s/demo/include");
  EXPECT_EQ(map.in_word("-isystem/ws/src/demo/include"), "-isystem/tmp/s/demo/include");
  EXPECT_EQ(map.in_word("-DDATA=\"/ws/src/demo/data\""), "-DDATA=\"/tmp/s/demo/data\"");
  EXPECT_EQ(map.in_word("a=/ws/src/demo:/ws/src/demo/x"), "a=/tmp/s/demo:/tmp/s/demo/x");
}

TEST(PathMap, what_only_looks_like_the_path_stays) {
  const PathMap map = demo();
  for (const char* word :
       {"/ws/src/demo2/a", "/ws/src/demo-x", "/mnt/ws/src/demo", "x/ws/src/demo", "-I/ws/src"})
    EXPECT_EQ(map.in_word(word), word);
}

TEST(PathMap, a_build_folder_in_the_package_stays) {
  EXPECT_EQ(demo().in_word("-I/ws/src/demo/build/include"), "-I/ws/src/demo/build/include");
  EXPECT_EQ(demo().in_word("/ws/src/demo/builder"), "/tmp/s/demo/builder");
}

TEST(PathMap, of_a_source_only_includes_change) {
  const std::string source =
      "#include \"/ws/src/demo/a.h\"\n #  include </ws/src/demo/b.h>\nconst char* p = \"/ws/src/demo\";\n";
  EXPECT_EQ(
      demo().in_includes(source),
      "#include \"/tmp/s/demo/a.h\"\n #  include </tmp/s/demo/b.h>\nconst char* p = \"/ws/src/demo\";\n");
}

}  // namespace
}  // namespace tzc::rewriter
