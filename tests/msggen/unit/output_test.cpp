// SPDX-License-Identifier: BSD-3-Clause
// All headers of a run, or none.
#include <gmock/gmock.h>

#include "tool/output.h"
#include "tool_case.h"

namespace tzc::msggen::test {
namespace {

using ::testing::HasSubstr;

class Output : public Tool {
 protected:
  std::string write_all(const std::vector<Header>& headers) {
    Diagnostics diagnostics;
    write_headers(headers, {path("out"), false}, diagnostics);
    std::string text;
    for (const Diagnostic& d : diagnostics.sorted()) text += render(d);
    return text;
  }
};

TEST_F(Output, a_folder_in_the_way_changes_nothing) {
  write("out/tzc/demo/A.h", "former");
  fs::create_directories(path("out/tzc/demo/B.h"));
  const auto before = fs::last_write_time(path("out/tzc/demo/A.h"));
  const std::string error =
      write_all({{"tzc/demo/A.h", "a"}, {"tzc/new/N.h", "n"}, {"tzc/demo/B.h", "b"}, {"tzc/demo/C.h", "c"}});
  EXPECT_THAT(error, HasSubstr("tzc/demo/B.h: a folder is in its place"));
  EXPECT_THAT(error, HasSubstr("nothing was generated"));
  EXPECT_THAT(files_below("out"), ::testing::ElementsAre("tzc/demo/A.h"));
  EXPECT_EQ(read("out/tzc/demo/A.h"), "former");
  EXPECT_EQ(fs::last_write_time(path("out/tzc/demo/A.h")), before);
  EXPECT_FALSE(fs::exists(path("out/tzc/new")));
}

// The same file twice: the second has nothing to move any more, when the others are in place.
TEST_F(Output, what_was_moved_before_a_failure_is_taken_back) {
  write("out/tzc/demo/A.h", "former");
  fs::create_symlink("A.h", path("out/tzc/demo/Link.h"));
  const std::string error = write_all(
      {{"tzc/demo/A.h", "a"}, {"tzc/demo/Link.h", "l"}, {"tzc/new/N.h", "n"}, {"tzc/new/N.h", "n"}});
  EXPECT_THAT(error, HasSubstr("tzc/new/N.h: No such file"));
  EXPECT_THAT(error, HasSubstr("nothing was generated"));
  EXPECT_EQ(read("out/tzc/demo/A.h"), "former");
  EXPECT_TRUE(fs::is_symlink(path("out/tzc/demo/Link.h")));
  EXPECT_THAT(files_below("out"), ::testing::UnorderedElementsAre("tzc/demo/A.h", "tzc/demo/Link.h"));
  EXPECT_FALSE(fs::exists(path("out/tzc/new")));
}

TEST_F(Output, nothing_temporary_stays) {
  write("out/tzc/demo/A.h", "former");
  EXPECT_EQ(write_all({{"tzc/demo/A.h", "a"}, {"tzc/demo/B.h", "b"}}), "");
  EXPECT_THAT(files_below("out"), ::testing::UnorderedElementsAre("tzc/demo/A.h", "tzc/demo/B.h"));
  EXPECT_EQ(read("out/tzc/demo/A.h"), "a");
}

}  // namespace
}  // namespace tzc::msggen::test
