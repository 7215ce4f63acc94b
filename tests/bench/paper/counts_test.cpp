// SPDX-License-Identifier: BSD-3-Clause
#include "paper/counts.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "temp_dir.h"

namespace {

using namespace tzc::bench;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using tzc::test::TempDir;

constexpr char of_an_earlier_run[] = R"({
  "types": [{"folder": "/a", "fields": ["a", "10", "4", "40.0", "2", "50.0"]},
            {"folder": "/b", "fields": ["b", "5", "1", "20.0", "1", "100.0"]}],
  "all_types": ["all", "12", "4", "33.3", "2", "50.0"],
  "effort": [{"folder": "/c", "fields": ["c", "1", "2", "3"]}]})";

struct CountedRows : testing::Test {
  std::vector<Section> sections() { return counted_sections(store, options, said); }

  TempDir folder;
  Store store{folder.path()};
  PaperOptions options;
  std::vector<std::string> said;
};

TEST_F(CountedRows, are_none_where_nobody_asked_for_them) {
  for (const Section& section : sections()) EXPECT_THAT(section.table.rows, IsEmpty()) << section.file;
  EXPECT_FALSE(store.has("counts.json"));
}

TEST_F(CountedRows, of_an_earlier_run_stay) {
  folder.write("counts.json", of_an_earlier_run);
  const std::vector<Section> all = sections();
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0].file, "types.csv");
  EXPECT_THAT(all[0].table.rows, ElementsAre(ElementsAre("a", "10", "4", "40.0", "2", "50.0"),
                                             ElementsAre("b", "5", "1", "20.0", "1", "100.0"),
                                             ElementsAre("all", "12", "4", "33.3", "2", "50.0")));
  EXPECT_EQ(all[1].file, "effort.csv");
  EXPECT_THAT(all[1].table.rows, ElementsAre(ElementsAre("c", "1", "2", "3")));
}

TEST_F(CountedRows, stay_where_they_cannot_be_counted_again) {
  folder.write("counts.json", of_an_earlier_run);
  options.types = {"/nonexistent/folder"};
  EXPECT_EQ(sections()[0].table.rows.size(), 3u);
  EXPECT_THAT(said, ElementsAre(HasSubstr("types of /nonexistent/folder: ")));
  options.types.clear();
  EXPECT_EQ(sections()[0].table.rows.size(), 3u) << "what was kept is what was shown";
}

TEST_F(CountedRows, that_are_damaged_are_named) {
  for (const char* content :
       {"{", "[]", "{}", R"({"types": [{"folder": "/a", "fields": []}], "all_types": [], "effort": []})"}) {
    folder.write("counts.json", content);
    try {
      sections();
      ADD_FAILURE() << content;
    } catch (const StoreError& error) {
      EXPECT_THAT(error.what(), HasSubstr("counts.json is not a result")) << content;
    }
  }
}

}  // namespace
