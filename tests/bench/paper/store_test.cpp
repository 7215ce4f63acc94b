// SPDX-License-Identifier: BSD-3-Clause
#include "paper/store.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "made_up.h"
#include "temp_dir.h"

namespace {

using namespace tzc::bench;
using nlohmann::json;
using tzc::test::made_up;
using tzc::test::TempDir;

const Cell cell{"tcpros", 4096, 2};

json run_with(std::size_t rounds) {
  return {{"begun", "now"},
          {"settings", {{"rounds", rounds}}},
          {"machine", "this"},
          {"versions", {{"tzc", "1"}}}};
}

std::string problem_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const StoreError& error) {
    return error.what();
  }
  return "";
}

TEST(Store, gives_back_what_was_saved) {
  const TempDir folder;
  Store(folder / "a/b").save({cell, {{3, made_up({{1, 0, 5'000'000'000}, {7, 8, 9}})}}});
  const CellResult loaded = Store(folder / "a/b").load(cell);
  ASSERT_EQ(loaded.rounds.size(), 1u);
  const Measurement& round = loaded.rounds.at(3);
  EXPECT_EQ(round.latency_ns, (std::vector<std::vector<std::uint64_t>>{{1, 0, 5'000'000'000}, {7, 8, 9}}));
  EXPECT_DOUBLE_EQ(round.seconds, 0.3);
  EXPECT_EQ(round.publisher.copied_bytes, 300u);
  EXPECT_EQ(round.subscribers.page_faults, 40u);
}

TEST(Store, has_no_rounds_of_another_cell) {
  const TempDir folder;
  const Store store(folder.path());
  store.save({cell, {{0, made_up({{1}, {2}})}}});
  EXPECT_TRUE(store.load({"tcpros", 4096, 4}).rounds.empty());
  EXPECT_TRUE(store.load({"tcpros", 8192, 2}).rounds.empty());
  EXPECT_TRUE(store.load({"tzc", 4096, 2}).rounds.empty());
}

TEST(Store, knows_the_cells_of_every_run) {
  const TempDir folder;
  const Store store(folder.path());
  store.save({cell, {{0, made_up({{1}, {2}})}}});
  store.save({{"tzc", 65536, 1, in_real_time_under_load}, {{0, made_up({{1}})}}});
  std::vector<Cell> cells = store.cells();
  ASSERT_EQ(cells.size(), 2u);
  if (cells[0].contender == "tzc") std::swap(cells[0], cells[1]);
  EXPECT_EQ(cells[0].contender, "tcpros");
  EXPECT_EQ(cells[1].size_bytes, 65536u);
  EXPECT_TRUE(cells[1].conditions == in_real_time_under_load);
  for (const Cell& one : cells) EXPECT_EQ(store.load(one).rounds.size(), 1u);
  folder.write("cells/other.json", "{}");
  EXPECT_NE(problem_of([&] { store.cells(); }).find("other.json is not a result"), std::string::npos);
  std::filesystem::remove_all(folder / "cells");
  EXPECT_NE(problem_of([&] { store.cells(); }).find("cannot read " + folder / "cells"), std::string::npos);
}

TEST(Store, removes_what_a_killed_process_left_half_written) {
  const TempDir folder;
  folder.write("cells/tcpros-4096-2.json.tmp", "{\"rou");
  folder.write("index.html.tmp", "<");
  const Store store(folder.path());
  EXPECT_FALSE(std::filesystem::exists(folder / "cells/tcpros-4096-2.json.tmp"));
  EXPECT_FALSE(std::filesystem::exists(folder / "index.html.tmp"));
}

TEST(Store, refuses_to_mix_two_kinds_of_runs) {
  const TempDir folder;
  const Store store(folder.path());
  store.begin(run_with(2));
  EXPECT_EQ(problem_of([&] { store.begin(run_with(2)); }), "");
  EXPECT_NE(problem_of([&] { store.begin(run_with(3)); }).find("--output"), std::string::npos);
  for (const char* part : {"machine", "versions"}) {
    json other = run_with(2);
    other[part] = "other";
    EXPECT_NE(problem_of([&] { store.begin(other); }).find(part), std::string::npos);
  }
}

TEST(Store, names_the_file_that_is_no_result) {
  const TempDir folder;
  const Store store(folder.path());
  for (const char* content : {"{\"rou", "{}", "[]", R"({"rounds": {"x": 1}})"}) {
    folder.write("cells/tcpros-4096-2.json", content);
    EXPECT_NE(problem_of([&] { (void)store.load(cell); }).find("tcpros-4096-2.json"), std::string::npos)
        << content;
  }
}

TEST(Store, has_its_folder_for_itself) {
  const TempDir folder;
  {
    const Store store(folder.path());
    folder.write("half.tmp", "it is being written");
    EXPECT_NE(problem_of([&] { Store(folder.path()); }).find("another run"), std::string::npos);
    EXPECT_EQ(folder.read("half.tmp"), "it is being written");
  }
  EXPECT_EQ(problem_of([&] { Store(folder.path()); }), "");
}

TEST(Store, says_which_folder_cannot_be_used) {
  const TempDir folder;
  folder.write("file", "");
  EXPECT_NE(problem_of([&] { Store(folder / "file"); }).find("file"), std::string::npos);
  const std::string too_long(300, 'n');
  EXPECT_NE(problem_of([&] { Store(folder / too_long); }).find(too_long), std::string::npos);
  EXPECT_NE(problem_of([&] { (void)Store::has_begun(folder / too_long); }).find(too_long), std::string::npos);
}

TEST(Store, names_the_description_that_is_none) {
  for (const char* content : {"[", "[]", "7", "null", "{}", R"({"settings": {"rounds": 2}})"}) {
    const TempDir folder;
    folder.write("run.json", content);
    const Store store(folder.path());
    EXPECT_NE(problem_of([&] { store.begin(run_with(2)); }).find("run.json"), std::string::npos) << content;
  }
}

TEST(Store, names_the_file_that_cannot_be_read) {
  const TempDir folder;
  folder.write("run.json/file", "");
  folder.write("cells/tcpros-4096-2.json/file", "");
  const Store store(folder.path());
  EXPECT_NE(problem_of([&] { store.begin(run_with(2)); }).find("run.json"), std::string::npos);
  EXPECT_NE(problem_of([&] { (void)store.load(cell); }).find("tcpros-4096-2.json"), std::string::npos);
}

// A link to itself, since root enters every folder that may be closed to others.
TEST(Store, says_how_a_folder_cannot_be_entered) {
  const TempDir folder;
  const std::string closed = folder / "closed";
  std::filesystem::create_symlink(closed, closed);
  EXPECT_NE(problem_of([&] { (void)Store::has_begun(closed); }).find("closed"), std::string::npos);
  EXPECT_NE(problem_of([&] { Store{closed}; }).find("closed"), std::string::npos);
}

}  // namespace
